#include "view_panel.h"

#include "text.h"

#include "core/preview/mesh_file.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QScrollArea>
#include <QVBoxLayout>

#include <array>

namespace mirrorball::studio {

namespace {

constexpr auto viewOf = [](auto& scene) -> auto& { return scene.view; };
constexpr auto cameraOf = [](auto& scene) -> auto& { return scene.view.camera; };
constexpr auto backgroundOf = [](auto& scene) -> auto& { return scene.view.background; };
constexpr auto probeOf = [](auto& scene) -> auto& { return scene.probe; };

auto backdropIs(Backdrop kind)
{
    return [kind](const Scene& scene) { return scene.view.background.kind == kind; };
}

/// Degrees of a full turn on the slider; more can be typed.
FieldStyle turnStyle(const QString& label)
{
    return {.label = label, .sliderLow = -180.0, .sliderHigh = 180.0, .step = 1.0};
}

const FieldStyle hidden{.isHidden = true};

} // namespace

void useMesh(Document& document, const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    document.edit(ViewPanel::tr("Open mesh"), {}, [&](Scene& scene) { scene.view.geometry = absolute.toStdString(); });
}

ViewPanel::ViewPanel(Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace)
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
    m_form->addHeading(tr("Object"));
    addGeometry();
    m_form->addFields("view", viewOf,
                      {{"tone", hidden}, {"exposure", hidden}, {"width", hidden}, {"height", hidden}, {"shading", {.label = tr("Shading")}}});
    m_form->addHeading(tr("Environment"));
    m_form->addFields("probe", probeOf,
                      {{"yaw", turnStyle(tr("Turn"))}, {"exposure", {.label = tr("Brightness"), .sliderLow = -8.0, .sliderHigh = 8.0, .step = 0.1}}});
    m_form->addFields("view.background", backgroundOf,
                      {{"kind", {.label = tr("Background")}},
                       {"blur", {.digits = 3, .isShown = backdropIs(Backdrop::Blurred)}},
                       {"color", {.isShown = backdropIs(Backdrop::Color)}}});
    m_form->addHeading(tr("Camera"));
    m_form->addFields("view.camera", cameraOf,
                      {{"yaw", turnStyle(tr("Longitude"))},
                       {"pitch", {.label = tr("Latitude"), .step = 1.0}},
                       {"roll", turnStyle(tr("Roll"))},
                       {"distance", {.sliderLow = 0.5, .sliderHigh = 50.0, .scale = Scale::Logarithmic}},
                       {"fov", {.label = tr("Field of view"), .sliderLow = 5.0, .sliderHigh = 120.0, .step = 1.0}},
                       {"target", {.step = 0.05}}});
    m_form->addHeading(tr("Display"));
    m_form->addFields("view", viewOf,
                      {{"shading", hidden},
                       {"exposure", {.sliderLow = -8.0, .sliderHigh = 8.0, .step = 0.1}},
                       {"tone", {.label = tr("Tone curve")}},
                       {"width", {.label = tr("Picture width")}},
                       {"height", {.label = tr("Picture height")}}});
    scroll->setWidget(m_form);
}

void ViewPanel::addGeometry()
{
    constexpr std::array bodies{"teapot", "torus", "sphere", "box"};
    auto* bodiesBox = new QuietCombo;
    for (const char* body : bodies)
        bodiesBox->addItem(labelText(body), QLatin1String(body));
    const int meshItem = static_cast<int>(bodies.size());
    bodiesBox->addItem(tr("Mesh file…"));
    connect(bodiesBox, &QComboBox::activated, this, [this, bodiesBox, meshItem](int index) {
        if (index == meshItem) {
            QStringList patterns;
            for (const std::string_view extension : preview::meshExtensions())
                patterns << u'*' + toQString(extension);
            const QString path = QFileDialog::getOpenFileName(this, tr("Open mesh"), {}, tr("Meshes (%1);;All files (*)").arg(patterns.join(u' ')));
            if (!path.isEmpty())
                useMesh(m_workspace.document, path);
        } else {
            m_workspace.document.edit(tr("Change geometry"), {},
                                      [&](Scene& scene) { scene.view.geometry = bodiesBox->itemData(index).toString().toStdString(); });
        }
        const int builtin = bodiesBox->findData(toQString(m_workspace.document.scene().view.geometry)); // a dialog may have been cancelled
        bodiesBox->setCurrentIndex(builtin >= 0 ? builtin : meshItem);
    });
    m_form->addControl(QStringLiteral("view.geometry"), {.name = "geometry", .help = "the body that the material is shown on, or a mesh file"},
                       {}, bodiesBox, [bodiesBox, meshItem](const Scene& scene) {
                           const QString shown = toQString(scene.view.geometry);
                           const int builtin = bodiesBox->findData(shown);
                           bodiesBox->setItemText(meshItem, builtin >= 0 ? tr("Mesh file…") : QFileInfo(shown).fileName());
                           bodiesBox->setCurrentIndex(builtin >= 0 ? builtin : meshItem);
                       });
}

} // namespace mirrorball::studio
