#include "material_panel.h"

#include "fresnel_curve.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/image_patterns.h"
#include "widgets/controls/text.h"
#include "widgets/files/recent_files.h"
#include "widgets/files/use_file.h"

#include "core/base/error.h"
#include "core/scene/material_presets.h"
#include "core/scene/scene_file.h"
#include "core/shading/conductor.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>

namespace mirrorball::studio {

namespace {

constexpr auto specularOf = [](auto& scene) -> auto& { return scene.material.specular; };
constexpr auto brdfOf = [](auto& scene) -> auto& { return scene.material.brdf; };
constexpr auto fresnelOf = [](auto& scene) -> auto& { return scene.material.fresnel; };
constexpr auto diffuseOf = [](auto& scene) -> auto& { return scene.material.diffuse; };
constexpr auto clearCoatOf = [](auto& scene) -> auto& { return scene.material.clearCoat; };
constexpr auto normalMapOf = [](auto& scene) -> auto& { return scene.material.normalMap; };
constexpr auto mapOf = [](auto& scene) -> auto& { return scene.map; };
constexpr auto materialOf = [](auto& scene) -> auto& { return scene.material; };

bool hasNoBrdf(const Scene& scene) { return scene.material.brdf.isNone(); }

auto lobeIs(SurfaceLobe lobe)
{
    return [lobe](const Scene& scene) { return scene.material.brdf.isNone() && scene.material.specular.lobe == lobe; };
}

bool hasClearCoat(const Scene& scene) { return scene.material.clearCoat.weight > 0.0; }

auto clearCoatIs(SurfaceLobe lobe)
{
    return [lobe](const Scene& scene) { return hasClearCoat(scene) && scene.material.clearCoat.lobe == lobe; };
}

auto fresnelIs(FresnelKind kind)
{
    return [kind](const Scene& scene) { return scene.material.brdf.isNone() && scene.material.fresnel.kind == kind; };
}

bool isCustomMetal(const Scene& scene)
{
    return hasNoBrdf(scene) && scene.material.fresnel.kind == FresnelKind::Conductor && scene.material.fresnel.metal == "custom";
}

/// Whether the reflection is read from levels of its map.
bool readsLevels(const Scene& scene) { return scene.map.mips || scene.material.lambda > 0.0; }

/// Whether the model shows a painted map alone: nothing here then has an effect.
bool isReplaced(const Scene& scene)
{
    const SphereMapSettings& map = scene.material.sphereMap;
    return !map.isNone() && map.use == SphereMapUse::Replace;
}

/// A weight of 0 to 2 on the slider; more can be typed.
FieldStyle weightStyle() { return {.sliderLow = 0.0, .sliderHigh = 2.0}; }

struct IndexPreset {
    const char* name;
    double index;
};
constexpr std::array indexPresets{IndexPreset{QT_TRANSLATE_NOOP("mirrorball::studio::MaterialPanel", "Water"), 1.333},
                                  IndexPreset{QT_TRANSLATE_NOOP("mirrorball::studio::MaterialPanel", "Glass"), 1.5},
                                  IndexPreset{QT_TRANSLATE_NOOP("mirrorball::studio::MaterialPanel", "Diamond"), 2.417}};

} // namespace

MaterialPanel::MaterialPanel(Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace)
{
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll);

    m_form = new OptionsForm(m_workspace.document);
    m_form->layout()->setContentsMargins(10, 10, 10, 10);
    m_form->addRow(makePresetRow(), OptionsForm::Span::Whole);
    m_form->addRow(makeReplacedNote(), OptionsForm::Span::Whole, isReplaced);
    addReflection();
    addBrdf();
    addFresnel();
    addDiffuse();
    addClearCoat();
    addNormalMap();
    addLookup();
    scroll->setWidget(m_form);
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Material))
            showPreset();
    });
    showPreset();
}

QWidget* MaterialPanel::makePresetRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_presets = new QuietCombo(row);
    m_presets->setObjectName(QStringLiteral("materialPresets"));
    m_presets->setAccessibleName(tr("Material preset"));
    m_presets->setToolTip(tr("Start from a built-in material"));
    m_presets->addItem(tr("Custom material"));
    for (const MaterialPreset& preset : materialPresets()) {
        m_presets->addItem(labelText(preset.name).replace(u'-', u' '), toQString(preset.name));
        m_presets->setItemData(m_presets->count() - 1, fieldText(preset.description), Qt::ToolTipRole);
    }
    connect(m_presets, &QComboBox::activated, this, [this](int index) {
        const MaterialPreset* preset = findMaterialPreset(m_presets->itemData(index).toString().toStdString());
        if (preset)
            m_workspace.document.edit(tr("Choose material"), {}, [&](Scene& scene) { scene.material = preset->material; });
        showPreset();
    });
    layout->addWidget(m_presets, 1);

    const auto button = [&](const char* icon, const QString& name, const QString& help, auto action) {
        auto* made = new QToolButton(row);
        made->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(icon))));
        made->setAccessibleName(name);
        made->setToolTip(help);
        made->setAutoRaise(true);
        connect(made, &QToolButton::clicked, this, action);
        layout->addWidget(made);
    };
    const QString ending = QStringLiteral(".material");
    const QString filter = tr("Materials and scenes (*.material *.json *.mirrorball);;All files (*)");
    button("open", tr("Open material"), tr("Take the material of a material or scene file"), [this, filter] {
        const QString path = askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Open material"), .filter = filter});
        if (!path.isEmpty())
            openMaterial(path);
    });
    button("save", tr("Save material"), tr("Save this material as a file of its own"), [this, filter, ending] {
        const QString path =
            askWhereToSave(
                this, {.purpose = QStringLiteral("save"), .title = tr("Save material"), .filter = filter, .start = tr("untitled") + ending},
                ending)
                .path;
        if (!path.isEmpty())
            saveMaterialAs(path);
    });
    return row;
}

QWidget* MaterialPanel::makeReplacedNote()
{
    auto* note = new QFrame;
    note->setObjectName(QStringLiteral("material.replaced"));
    note->setProperty("role", QStringLiteral("notice"));
    auto* text = new QLabel(tr("The sphere map is shown in place of this material: nothing below changes the picture."));
    text->setWordWrap(true);
    auto* over = new QPushButton(tr("Lay it over the material"));
    over->setObjectName(QStringLiteral("material.showUnderMap"));
    over->setAccessibleName(over->text());
    over->setToolTip(tr("Uses the sphere map over the reflecting material; the Sphere map dock has the other uses"));
    connect(over, &QPushButton::clicked, this, [this] {
        m_workspace.document.edit(tr("Change use of the map"), {}, [](Scene& scene) { scene.material.sphereMap.use = SphereMapUse::Over; });
    });
    auto* column = new QVBoxLayout(note);
    column->setContentsMargins(8, 6, 8, 6);
    column->addWidget(text);
    column->addWidget(over, 0, Qt::AlignLeft);
    return note;
}

void MaterialPanel::openMaterial(const QString& path) { useMaterial(m_workspace, path); }

void MaterialPanel::saveMaterialAs(const QString& path)
{
    try {
        saveMaterial(m_workspace.document.scene(), toPath(path));
        rememberRecent(path, FileKind::Material);
        m_workspace.notices.clear(QStringLiteral("material"));
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("material"), .text = QString::fromUtf8(error.what())});
    }
}

void MaterialPanel::addReflection()
{
    m_form->addHeading(tr("Reflection"));
    m_form->addFields(
        "material.specular", specularOf,
        {{"lobe", {.isShown = hasNoBrdf}},
         {"exponent", {.sliderLow = 0.1, .sliderHigh = 1e6, .scale = Scale::Logarithmic, .isShown = lobeIs(SurfaceLobe::Phong)}},
         {"roughness", {.digits = 3, .isShown = lobeIs(SurfaceLobe::Ggx)}},
         {"weight", weightStyle()}});
    m_form->addFields("material", materialOf,
                      {{"combine", {.isHidden = true}},
                       {"lambda", {.label = tr("Lambda"), .sliderLow = 0.0, .sliderHigh = 10.0, .step = 0.1}},
                       {"lambda_grazing",
                        {.label = tr("At grazing"),
                         .sliderLow = 0.0,
                         .sliderHigh = 1.0,
                         .isShown = [](const Scene& scene) { return scene.material.lambda > 0.0; }}},
                       {"lod_bias", {.label = tr("LOD bias"), .sliderLow = -4.0, .sliderHigh = 8.0, .step = 0.1}}});
}

void MaterialPanel::addBrdf()
{
    m_form->addHeading(tr("Lobe that knows the view"));
    m_form->addFields("material.brdf", brdfOf,
                      {{"model",
                        {.label = tr("BRDF"),
                         .isText = true,
                         .suggestions = {QStringLiteral("ggx:roughness=0.5,metal=gold"), QStringLiteral("ggx:roughness=0.4,ior=1.5"),
                                         QStringLiteral("beckmann:alpha=0.25,metal=aluminium"),
                                         QStringLiteral("ward:alpha=0.2,metal=copper"), QStringLiteral("phong:exponent=50")}}},
                       {"lookups", {.label = tr("Lookups"), .isShown = [](const Scene& scene) { return !hasNoBrdf(scene); }}}});
    if (auto* model = qobject_cast<QLineEdit*>(m_form->control(QStringLiteral("material.brdf.model"))))
        model->setPlaceholderText(tr("none: a model or a measured file"));
}

// Kind and size of the map have their place in the map's dock.
void MaterialPanel::addLookup()
{
    m_form->addHeading(tr("Lookup in the map"));
    m_form->addFields(
        "map", mapOf,
        onlyFields<MapSettings>(
            {{"mips", {.label = tr("Coarser levels")}},
             {"mip_filtering",
              {.label = tr("Mip filtering"),
               .isShown = [](const Scene& scene) { return readsLevels(scene) && scene.map.parameterization == Parameterization::Cube; }}},
             {"anisotropy", {.isShown = readsLevels}},
             {"space", {.label = tr("Space")}}}));
}

void MaterialPanel::addFresnel()
{
    m_form->addHeading(tr("Fresnel"));
    m_form->addFields(
        "material.fresnel", fresnelOf,
        {{"kind", {.isShown = hasNoBrdf}},
         {"index", {.sliderLow = 1.0, .sliderHigh = 200.0, .scale = Scale::Logarithmic, .isShown = fresnelIs(FresnelKind::Dielectric)}},
         {"n", {.isHidden = true}},
         {"k", {.isHidden = true}}});

    auto* presets = new QWidget;
    auto* row = new QHBoxLayout(presets);
    row->setContentsMargins(0, 0, 0, 0);
    for (const IndexPreset& preset : indexPresets) {
        auto* button = new QToolButton(presets);
        button->setText(tr(preset.name));
        button->setAccessibleName(tr("Index of %1").arg(tr(preset.name).toLower()));
        button->setToolTip(tr("Index of refraction %1").arg(preset.index));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this, [this, preset] {
            m_workspace.document.edit(tr("Choose index"), {}, [&](Scene& scene) { scene.material.fresnel.index = preset.index; });
        });
        row->addWidget(button);
    }
    m_form->addRow(presets, OptionsForm::Span::Controls, fresnelIs(FresnelKind::Dielectric));

    auto* metals = new QuietCombo;
    for (const Conductor& metal : conductors())
        metals->addItem(labelText(metal.name), toQString(metal.name));
    metals->addItem(tr("Custom"), QStringLiteral("custom"));
    connect(metals, &QComboBox::activated, this, [this, metals](int index) {
        m_workspace.document.edit(tr("Choose metal"), {}, [&](Scene& scene) {
            FresnelSettings& fresnel = scene.material.fresnel;
            const std::string chosen = metals->itemData(index).toString().toStdString();
            if (chosen == "custom")
                if (const auto before = conductorFromName(fresnel.metal)) { // start from where one was
                    fresnel.n = before->n;
                    fresnel.k = before->k;
                }
            fresnel.metal = chosen;
        });
    });
    m_form->addControl(
        QStringLiteral("material.fresnel.metal"), {.name = "metal", .help = "conductor: name of a metal, or custom for n and k below"},
        {.isShown = fresnelIs(FresnelKind::Conductor)}, metals,
        [metals](const Scene& scene) { metals->setCurrentIndex(metals->findData(toQString(scene.material.fresnel.metal))); });
    const FieldStyle component{.step = 0.05, .isShown = isCustomMetal};
    m_form->addFields("material.fresnel", fresnelOf, onlyFields<FresnelSettings>({{"n", component}, {"k", component}}));
    m_form->addRow(new FresnelCurve(m_workspace.document), OptionsForm::Span::Whole,
                   [](const Scene& scene) { return hasNoBrdf(scene) && scene.material.fresnel.kind != FresnelKind::None; });
}

void MaterialPanel::addDiffuse()
{
    m_form->addHeading(tr("Diffuse"));
    m_form->addFields("material.diffuse", diffuseOf,
                      {{"weight", weightStyle()}, {"picture", {.isText = true, .fileFilter = imageFilter()}}});
    m_form->addFields("material", materialOf, onlyFields<Material>({{"combine", {.label = tr("Combine")}}}));
}

void MaterialPanel::addClearCoat()
{
    m_form->addHeading(tr("Clear coat"));
    m_form->addFields(
        "material.clear_coat", clearCoatOf,
        {{"weight", {.step = 0.05}},
         {"index", {.sliderLow = 1.0, .sliderHigh = 4.0, .isShown = hasClearCoat}},
         {"combine", {.isShown = hasClearCoat}},
         {"lobe", {.isShown = hasClearCoat}},
         {"exponent", {.sliderLow = 0.1, .sliderHigh = 1e6, .scale = Scale::Logarithmic, .isShown = clearCoatIs(SurfaceLobe::Phong)}},
         {"roughness", {.digits = 3, .isShown = clearCoatIs(SurfaceLobe::Ggx)}}});
}

void MaterialPanel::addNormalMap()
{
    m_form->addHeading(tr("Normal map"));
    m_form->addFields(
        "material.normal_map", normalMapOf,
        {{"source", {.label = tr("Normals"), .isText = true, .fileFilter = imageFilter()}},
         {"strength", {.step = 0.05, .isShown = [](const Scene& scene) { return !scene.material.normalMap.source.empty(); }}}});
}

void MaterialPanel::showPreset()
{
    const QSignalBlocker quiet(m_presets);
    m_presets->setCurrentIndex(0);
    for (const MaterialPreset& preset : materialPresets())
        if (preset.material == m_workspace.document.scene().material)
            m_presets->setCurrentIndex(m_presets->findData(toQString(preset.name)));
}

} // namespace mirrorball::studio
