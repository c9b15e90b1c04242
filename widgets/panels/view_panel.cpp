#include "view_panel.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/text.h"
#include "widgets/files/file_kind.h"
#include "widgets/files/use_file.h"
#include "widgets/spheremap/sphere_map_source_field.h"

#include "core/base/error.h"
#include "core/spheremap/document/presets.h"

#include <QFileInfo>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

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

/// The camera of a geometry's first view, with what the artist chose of the lens.
CameraSettings firstView(const std::string& geometry, const CameraSettings& now)
{
    CameraSettings camera = initialCamera(geometry);
    camera.projection = now.projection;
    camera.fieldOfViewDeg = now.fieldOfViewDeg;
    camera.unknown = now.unknown;
    return camera;
}

/// The sphere map that a window begins with, as far as lines of sight go.
SphereMapSettings firstOutside() { return {.source = windowViewPresets().front().name, .space = MapSpace::World, .size = 1024}; }

/// Degrees of a full turn on the slider; more can be typed.
FieldStyle turnStyle(const QString& label) { return {.label = label, .sliderLow = -180.0, .sliderHigh = 180.0, .step = 1.0}; }

const FieldStyle hidden{.isHidden = true};

} // namespace

void useGeometry(Scene& scene, const std::string& geometry)
{
    const std::string before = scene.view.geometry;
    if (geometry == before)
        return;
    scene.view.geometry = geometry;
    CameraSettings& camera = scene.view.camera;
    if (showsWindow(scene) || camera == firstView(before, camera))
        camera = firstView(geometry, camera);
    SphereMapSettings& map = scene.material.sphereMap;
    WindowSettings& window = scene.view.window;
    if (showsWindow(scene) && map.isNone()) {
        map = firstOutside();
        if (window.middle.empty() && window.far.empty()) {
            window.middle = windowViewPresets()[1].name;
            window.far = windowViewPresets()[2].name;
        }
    } else if (builtinGeometry(before) == GeometryKind::Window && map == firstOutside()) {
        map = {}; // no material for a model
    }
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
    addWindow();
    m_form->addFields(
        "view", viewOf,
        onlyFields<ViewSettings>(
            {{"tessellation", {.label = tr("Tessellation"), .isShown = [](const Scene& scene) { return !showsWindow(scene); }}},
             {"shading", {.label = tr("Shading")}}}));
    m_form->addHeading(tr("Environment"));
    m_form->addFields(
        "probe", probeOf,
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
                       {"dither", {.label = tr("Dithering")}},
                       {"width", {.label = tr("Picture width")}},
                       {"tessellation", hidden},
                       {"height", {.label = tr("Picture height")}}});
    addDisplay();
    scroll->setWidget(m_form);
}

void ViewPanel::addGeometry()
{
    auto* bodiesBox = new QuietCombo;
    for (const std::string_view body : words(GeometryKind{}))
        bodiesBox->addItem(labelText(body), toQString(body));
    const int meshItem = bodiesBox->count();
    bodiesBox->addItem(tr("Mesh file…"));
    bodiesBox->setIconSize({24, 24});
    m_bodies = bodiesBox;
    connect(&m_workspace.meshes, &MeshThumbnails::made, this, &ViewPanel::showBodyPictures);
    connect(bodiesBox, &QComboBox::activated, this, [this, bodiesBox, meshItem](int index) {
        if (index == meshItem) {
            const QString path =
                askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Open mesh"), .filter = filterOf(FileKind::Mesh)});
            if (!path.isEmpty())
                useMesh(m_workspace, path);
        } else {
            m_workspace.document.edit(tr("Change geometry"), {},
                                      [&](Scene& scene) { useGeometry(scene, bodiesBox->itemData(index).toString().toStdString()); });
        }
        const int builtin = bodiesBox->findData(toQString(m_workspace.document.scene().view.geometry)); // a dialog may have been cancelled
        bodiesBox->setCurrentIndex(builtin >= 0 ? builtin : meshItem);
    });
    m_form->addControl(
        QStringLiteral("view.geometry"), {.name = "geometry", .help = "the body that the material is shown on, or a mesh file"}, {},
        bodiesBox, [this, bodiesBox, meshItem](const Scene& scene) {
            const QString shown = toQString(scene.view.geometry);
            if (bodiesBox->itemData(meshItem, Qt::UserRole + 1).toString() != shown) { // files are not looked at while something is dragged
                bodiesBox->setItemData(meshItem, shown, Qt::UserRole + 1);
                showBodyPictures();
            }
            const int builtin = bodiesBox->findData(shown);
            bodiesBox->setItemText(meshItem, builtin >= 0 ? tr("Mesh file…") : QFileInfo(shown).fileName());
            bodiesBox->setCurrentIndex(builtin >= 0 ? builtin : meshItem);
        });
}

void ViewPanel::showBodyPictures()
{
    if (!isVisible())
        return;
    const int meshItem = m_bodies->count() - 1;
    for (int i = 0; i < meshItem; ++i)
        if (const QString body = m_bodies->itemData(i).toString(); body != QStringLiteral("window"))
            m_bodies->setItemIcon(i, m_workspace.meshes.icon(body));
    const Scene& scene = m_workspace.document.scene();
    const bool isFile = !builtinGeometry(scene.view.geometry);
    m_bodies->setItemIcon(meshItem,
                          isFile ? m_workspace.meshes.icon(QFileInfo(toQString(resolved(scene, scene.view.geometry))).absoluteFilePath())
                                 : QIcon());
}

void ViewPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showBodyPictures();
}

// What lies outside, the nearest first. The nearest is the material's sphere map, which may be painted in its dock.
void ViewPanel::addWindow()
{
    const auto addSource = [this](const char* path, const Field& field, const QString& label, std::function<bool(const Scene&)> isShown,
                                  auto select) {
        auto* control = new SphereMapSourceField(m_workspace.presets);
        connect(control, &SphereMapSourceField::edited, this, [this, label, select](const QString& source) {
            m_workspace.document.edit(tr("Change %1").arg(label.toLower()), {},
                                      [&](Scene& scene) { select(scene) = source.toStdString(); });
        });
        m_form->addControl(QLatin1String(path), field, {.label = label, .isShown = std::move(isShown)}, control,
                           [control, select](const Scene& scene) { control->setSource(toQString(select(scene))); });
        control->describe(label, labelText(field.help));
    };
    const auto addDepth = [this](const char* name, const QString& label, std::function<bool(const Scene&)> isShown) {
        m_form->addFields(
            "view.window", [](auto& scene) -> auto& { return scene.view.window; },
            onlyFields<WindowSettings>(
                {{name,
                  {.label = label, .sliderLow = 0.1, .sliderHigh = 1e4, .scale = Scale::Logarithmic, .isShown = std::move(isShown)}}}));
    };
    addSource(
        "view.window.nearest", fieldNamed<SphereMapSettings>("source"), tr("Outside"),
        [](const Scene& scene) { return showsWindow(scene) && !scene.material.sphereMap.document; },
        [](auto& scene) -> auto& { return scene.material.sphereMap.source; });
    addDepth("depth", tr("Its depth"), showsWindow);
    addSource(
        "view.window.middle", fieldNamed<WindowSettings>("middle"), tr("Behind it"), showsWindow,
        [](auto& scene) -> auto& { return scene.view.window.middle; });
    addDepth("middle_depth", tr("Middle depth"),
             [](const Scene& scene) { return showsWindow(scene) && !scene.view.window.middle.empty(); });
    addSource(
        "view.window.far", fieldNamed<WindowSettings>("far"), tr("Farthest"), showsWindow,
        [](auto& scene) -> auto& { return scene.view.window.far; });
    addDepth("far_depth", tr("Far depth"), [](const Scene& scene) { return showsWindow(scene) && !scene.view.window.far.empty(); });
}

// One list of what can be chosen: sRGB, the views of $OCIO or of the scene's configuration, or another file.
void ViewPanel::addDisplay()
{
    m_displays = new QuietCombo;
    m_displays->addItem(tr("sRGB"));
    m_displays->addItem(tr("OpenColorIO file…"));
    connect(m_displays, &QComboBox::activated, this, [this](int index) {
        const QStringList chosen = m_displays->itemData(index).toStringList();
        if (index == 0) {
            setDisplay({});
        } else if (chosen.size() == 3) {
            setDisplay({.config = chosen[0].toStdString(), .display = chosen[1].toStdString(), .view = chosen[2].toStdString()});
        } else {
            const QString path = askForFile(
                this,
                {.purpose = QStringLiteral("open"), .title = tr("Open OpenColorIO configuration"), .filter = filterOf(FileKind::Display)});
            if (!path.isEmpty())
                openDisplayConfig(path);
            showDisplay(m_workspace.document.scene()); // the dialog may have been cancelled
        }
    });
    m_form->addControl(QStringLiteral("view.display"),
                       {.name = "display", .help = "sRGB, or a display and view of an OpenColorIO configuration"}, {}, m_displays,
                       [this](const Scene& scene) { showDisplay(scene); });
}

void ViewPanel::openDisplayConfig(const QString& path) { useDisplay(m_workspace, path); }

void ViewPanel::setDisplay(DisplaySettings display)
{
    m_workspace.document.edit(tr("Change display"), {}, [&](Scene& scene) {
        display.unknown = scene.view.display.unknown;
        scene.view.display = display;
    });
}

// A configuration may be large and lie on another machine: it is read in the background. What is wrong with it, the picture's notice says.
void ViewPanel::showDisplay(const Scene& scene)
{
    const DisplaySettings& display = scene.view.display;
    const std::string config = display.config.empty() && qEnvironmentVariableIsSet("OCIO") ? "env"
                               : display.config.empty() || display.config == "env"         ? display.config
                                                                                           : resolved(scene, display.config);
    if (config != std::exchange(m_offered, config) && !config.empty())
        m_offers.start(
            [config](const JobControl&) {
                try {
                    return preview::displayOffers(config);
                } catch (const Error&) {
                    return std::vector<preview::DisplayOffer>{};
                }
            },
            [this, config](const std::vector<preview::DisplayOffer>& offers) { offer(config, offers); });
    int index = display.config.empty() ? 0 : -1;
    for (int i = 1; i < m_displays->count() - 1 && index < 0; ++i) {
        const QStringList item = m_displays->itemData(i).toStringList();
        if (item.value(0) == toQString(config) && (display.display.empty() || item.value(1) == toQString(display.display)) &&
            (display.view.empty() || item.value(2) == toQString(display.view)))
            index = i;
    }
    m_displays->setCurrentIndex(index);
    m_displays->setPlaceholderText(toQString(display.view.empty() ? display.config : display.view));
}

void ViewPanel::offer(const std::string& config, const std::vector<preview::DisplayOffer>& offers)
{
    while (m_displays->count() > 2)
        m_displays->removeItem(1);
    for (const preview::DisplayOffer& each : offers)
        for (const std::string& view : each.views)
            m_displays->insertItem(m_displays->count() - 1, QStringLiteral("%1: %2").arg(toQString(each.display), toQString(view)),
                                   QStringList{toQString(config), toQString(each.display), toQString(view)});
    showDisplay(m_workspace.document.scene());
}

} // namespace mirrorball::studio
