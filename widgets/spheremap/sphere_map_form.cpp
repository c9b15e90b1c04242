#include "sphere_map_form.h"

#include "sphere_map_source_field.h"
#include "widgets/controls/form_labels.h"
#include "widgets/controls/image_patterns.h"
#include "widgets/controls/text.h"

#include "core/scene/sphere_map_source.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

constexpr auto mapOf = [](auto& scene) -> auto& { return scene.material.sphereMap; };
constexpr auto flecksOf = [](auto& scene) -> auto& { return scene.material.sphereMap.flecks; };

bool isOnModel(const Scene& scene) { return !showsWindow(scene); }

/// The scene's own map, where the scene has one.
bool isOwn(const Scene& scene) { return static_cast<bool>(scene.material.sphereMap.document); }

} // namespace

// ---- the row -------------------------------------------------------------------------------------------------------------------

SphereMapUseRow::SphereMapUseRow(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_use(new QuietCombo), m_opacity(new NumberField({.initial = 1.0, .digits = 3})),
      m_color(new ColorButton)
{
    const auto describe = [](QWidget* control, std::string_view field, const QString& name) {
        control->setObjectName(QStringLiteral("material.sphere_map.") + toQString(field));
        control->setAccessibleName(name);
        control->setToolTip(labelText(fieldNamed<SphereMapSettings>(field).help));
    };
    describe(m_use, "use", tr("Use of the map"));
    for (const std::string_view word : words(SphereMapUse{}))
        m_use->addItem(labelText(word));
    connect(m_use, &QComboBox::activated, this, [this](int index) {
        m_document.edit(tr("Change use of the map"), {}, [index](Scene& scene) { mapOf(scene).use = static_cast<SphereMapUse>(index); });
    });
    describe(m_opacity, "opacity", tr("Opacity of the map"));
    m_opacity->describe(tr("Opacity of the map"), tr("How much of the map shows"));
    connect(m_opacity, &NumberField::edited, this, [this](double value) {
        m_document.edit(tr("Change opacity of the map"), m_opacity->objectName(), [value](Scene& scene) { mapOf(scene).opacity = value; });
    });
    connect(m_opacity, &NumberField::finished, &m_document, &Document::finishEdit);
    describe(m_color, "color", tr("Surface color below the map"));
    m_color->setMinimumWidth(44);
    connect(m_color, &ColorButton::edited, this, [this](const glm::dvec3& color) {
        m_document.edit(tr("Change surface color"), m_color->objectName(), [&](Scene& scene) { mapOf(scene).color = color; });
    });
    connect(m_color, &ColorButton::finished, &m_document, &Document::finishEdit);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 6, 8, 2);
    row->setSpacing(6);
    row->addWidget(m_use, 2);
    row->addWidget(m_opacity, 3);
    row->addWidget(m_color);
    connect(&m_document, &Document::changed, this, &SphereMapUseRow::follow);
    follow();
}

void SphereMapUseRow::follow()
{
    const SphereMapSettings& map = m_document.scene().material.sphereMap;
    setVisible(isOnModel(m_document.scene())); // outside a window it is all there is
    m_use->setCurrentIndex(static_cast<int>(map.use));
    m_opacity->setValue(map.opacity);
    m_color->setColor(map.color);
    m_color->setVisible(hidesMaterial(map.use));
}

// ---- the form ------------------------------------------------------------------------------------------------------------------

SphereMapForm::SphereMapForm(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_form(new OptionsForm(workspace.document))
{
    const std::string path = "material.sphere_map";
    addSource();
    const auto isPicture = [](const Scene& scene) { return !isOwn(scene) && isSphereMapPicture(mapOf(scene).source); };
    m_form->addFields(path, mapOf, onlyFields<SphereMapSettings>({{"fit", {.label = tr("Shape"), .isShown = isPicture}}}));
    m_form->addHeading(tr("Lookup"));
    addIndex();
    m_form->addFields(path, mapOf,
                      onlyFields<SphereMapSettings>(
                          {{"space", {.label = tr("Space")}}, {"lookup", {.label = tr("Looked up per"), .isShown = isOnModel}}}));
    m_form->addHeading(tr("Resolution"));
    m_form->addFields(
        path, mapOf,
        onlyFields<SphereMapSettings>({{"size", {.choices = {128, 256, 512, 1024, 2048, 4096}}}, {"levels", {.isShown = isOnModel}}}));
    auto* flecks = new QLabel(tr("Flecks"));
    flecks->setProperty("role", QStringLiteral("heading"));
    m_form->addRow(flecks, OptionsForm::Span::Whole, isOnModel);
    m_form->addFields(path + ".flecks", flecksOf,
                      {{"density", {.digits = 3, .isShown = isOnModel}},
                       {"size", {.sliderLow = 2e-3, .sliderHigh = 0.2, .scale = Scale::Logarithmic, .isShown = isOnModel}},
                       {"spread", {.digits = 3, .isShown = isOnModel}},
                       {"seed", {.isShown = isOnModel}},
                       {"pattern", {.isShown = isOnModel, .isText = true, .fileFilter = imageFilter()}}});
    addWords();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 8);
    column->addWidget(m_form);
    column->addStretch(1);
}

void SphereMapForm::addSource()
{
    auto* control = new SphereMapSourceField(m_workspace.presets);
    connect(control, &SphereMapSourceField::edited, this, [this](const QString& source) {
        m_workspace.document.edit(tr("Change the sphere map"), {}, [&](Scene& scene) { mapOf(scene).source = source.toStdString(); });
    });
    const Field field = fieldNamed<SphereMapSettings>("source");
    m_form->addControl(QStringLiteral("material.sphere_map.source"), field, {.isShown = [](const Scene& scene) { return !isOwn(scene); }},
                       control, [control](const Scene& scene) { control->setSource(toQString(mapOf(scene).source)); });
    control->describe(labelText(field.name), labelText(field.help));
}

void SphereMapForm::addIndex()
{
    auto* control = new QuietCombo;
    for (const std::string_view word : words(SphereMapIndex{}))
        control->addItem(labelText(word));
    connect(control, &QComboBox::activated, this, [this](int index) {
        m_workspace.sphereMap.edit(tr("Change index"), {},
                                   [index](SphereMapDocument& map) { map.index = static_cast<SphereMapIndex>(index); });
    });
    m_form->addControl(QStringLiteral("material.sphere_map.document.index"), fieldNamed<SphereMapDocument>("index"),
                       {.label = tr("Looked up by"), .isShown = isOwn}, control, [control](const Scene& scene) {
                           if (isOwn(scene))
                               control->setCurrentIndex(static_cast<int>(mapOf(scene).document.document->index));
                       });
}

void SphereMapForm::addWords()
{
    auto* heading = new QLabel(tr("About"));
    heading->setProperty("role", QStringLiteral("heading"));
    m_form->addRow(heading, OptionsForm::Span::Whole, isOwn);
    const auto add = [this](const char* name, std::string SphereMapDocument::*text) {
        auto* control = new QLineEdit;
        connect(control, &QLineEdit::editingFinished, this, [this, control, text] {
            m_workspace.sphereMap.edit(tr("Change %1").arg(control->accessibleName().toLower()), {},
                                       [&](SphereMapDocument& map) { map.*text = control->text().trimmed().toStdString(); });
        });
        m_form->addControl(QStringLiteral("material.sphere_map.document.") + QLatin1String(name), fieldNamed<SphereMapDocument>(name),
                           {.isShown = isOwn}, control, [control, text](const Scene& scene) {
                               if (!isOwn(scene))
                                   return;
                               const QString shown = toQString((*mapOf(scene).document.document).*text);
                               if (control->text() != shown) {
                                   control->setText(shown);
                                   control->setCursorPosition(0);
                               }
                           });
    };
    add("title", &SphereMapDocument::title);
    add("description", &SphereMapDocument::description);
}

} // namespace mirrorball::studio
