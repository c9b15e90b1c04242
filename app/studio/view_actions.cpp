#include "view_actions.h"

#include "command_keys.h"
#include "theme.h"
#include "widgets/controls/text.h"
#include "widgets/panels/view_panel.h"

#include <QCoreApplication>
#include <QSettings>
#include <QToolButton>
#include <QWidgetAction>

namespace mirrorball::studio {

ViewActions::ViewActions(PreviewWidget& preview, Workspace& workspace, QObject* parent)
    : QObject(parent), m_preview(preview), m_workspace(workspace), m_geometry(this), m_shading(this), m_projection(this),
      m_background(this), m_compare(this), m_turn(this), m_mouse(this)
{
    makeGeometry();
    makeShading();
    makeCamera();
    makeBackground();
    makeComparison();
    makeHabits();
    makeInspection();
    connect(&m_workspace.document, &Document::changed, this, &ViewActions::refresh);
    refresh();
}

QAction* ViewActions::add(const char* id, const char* iconName, const QString& text, const QString& help, const QKeySequence& key,
                          std::function<void()> act)
{
    auto* action = new QAction(icon(iconName), text, this);
    action->setObjectName(QLatin1String(id));
    action->setShortcut(key);
    const QString keys = key.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, keys));
    action->setStatusTip(help);
    if (isPlainKey(key)) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_plainKeys << action;
    }
    connect(action, &QAction::triggered, this, [this, act = std::move(act)] {
        const int before = m_workspace.document.undoStack().index();
        const Scene scene = m_workspace.document.scene();
        act();
        if (m_workspace.document.undoStack().index() != before || m_workspace.document.scene() != scene)
            say();
    });
    return action;
}

void ViewActions::popUp(const QPoint& global, const QList<QAction*>& others)
{
    auto* menu = new QMenu(&m_preview);
    menu->setObjectName(QStringLiteral("pictureMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(m_camera);
    menu->addActions(m_exposure);
    menu->addSeparator();
    for (const auto& [title, group] :
         {std::pair{tr("&Geometry"), &m_geometry}, std::pair{tr("&Shading"), &m_shading}, std::pair{tr("&Background"), &m_background}})
        menu->addMenu(title)->addActions(group->actions());
    menu->addSeparator();
    menu->addAction(m_snapshot);
    menu->addActions(m_compare.actions());
    menu->addSeparator();
    menu->addActions(m_inspect);
    menu->addSeparator();
    menu->addActions(others);
    menu->popup(global);
}

void ViewActions::addKeysTo(QWidget& widget) { widget.addActions(m_plainKeys); }

/// What was done, and that it can be taken back: a key may have been pressed by mistake.
void ViewActions::say()
{
    const QString done = m_workspace.document.undoStack().undoText();
    const double exposure = m_workspace.document.scene().view.exposure;
    const bool isExposure = done == tr("Change exposure") || done == tr("Reset exposure");
    emit said(tr("%1. Ctrl+Z takes it back").arg(isExposure ? tr("Exposure %1 EV").arg(exposure, 0, 'g', 4) : done));
}

QAction* ViewActions::addChoice(QActionGroup& group, const char* id, const char* iconName, const QString& text, const QKeySequence& key,
                                const QString& undoLabel, std::function<void(Scene&)> choose, std::function<bool(const Scene&)> isOn)
{
    QAction* action = add(id, iconName, text, text, key, [this, undoLabel, text, choose = std::move(choose)] {
        m_workspace.document.edit(QStringLiteral("%1: %2").arg(undoLabel, text), {}, choose);
    });
    action->setCheckable(true);
    group.addAction(action);
    m_choices.push_back({action, std::move(isOn)});
    return action;
}

void ViewActions::makeGeometry()
{
    const auto body = [this](GeometryKind kind, const QString& text) {
        const std::string word(wordOf(kind));
        addChoice(
            m_geometry, word.c_str(), word.c_str(), text, {}, tr("Change geometry"), [word](Scene& scene) { useGeometry(scene, word); },
            [kind](const Scene& scene) { return builtinGeometry(scene.view.geometry) == kind; });
    };
    body(GeometryKind::Teapot, tr("Teapot"));
    body(GeometryKind::Torus, tr("Torus"));
    body(GeometryKind::Sphere, tr("Sphere"));
    body(GeometryKind::Box, tr("Box"));
    body(GeometryKind::Window, tr("Window of a room"));
}

void ViewActions::makeShading()
{
    const auto view = [this](Shading shading, const char* iconName, const QString& text) {
        addChoice(
            m_shading, iconName, iconName, text, QKeySequence(Qt::Key_1 + static_cast<int>(shading)), tr("Change shading"),
            [shading](Scene& scene) { scene.view.shading = shading; },
            [shading](const Scene& scene) { return scene.view.shading == shading; });
    };
    view(Shading::Material, "material", tr("Material"));
    view(Shading::Wireframe, "wireframe", tr("Wireframe"));
    view(Shading::Normals, "normals", tr("Normals"));
    view(Shading::TexCoords, "texcoords", tr("Texture coordinates"));
    view(Shading::Seams, "seams", tr("Seams of the map"));
    view(Shading::Mips, "mips", tr("Mip levels"));
    view(Shading::NormalLines, "normal-lines", tr("Normals as lines"));
    view(Shading::Bounds, "bounds", tr("Bounding box"));
    m_lookup = add("view.lookup", "lookup-vertex", tr("&Interpolate texture coordinates at vertices, as in 1999"),
                   tr("Looks sphere maps up between the vertices of the mesh, as the hardware of the papers did; otherwise at every pixel"),
                   {}, [this] {
                       m_workspace.document.edit(tr("Change lookup"), {}, [](Scene& scene) {
                           LookupAt& lookup = scene.material.sphereMap.lookup;
                           lookup = lookup == LookupAt::Vertex ? LookupAt::Pixel : LookupAt::Vertex;
                       });
                   });
    m_lookup->setCheckable(true);
    m_choices.push_back({m_lookup, [](const Scene& scene) { return scene.material.sphereMap.lookup == LookupAt::Vertex; }});
}

void ViewActions::makeCamera()
{
    const auto project = [this](Projection projection, const char* iconName, const QString& text) {
        addChoice(
            m_projection, iconName, iconName, text, {}, tr("Change projection"),
            [projection](Scene& scene) { scene.view.camera.projection = projection; },
            [projection](const Scene& scene) { return scene.view.camera.projection == projection; });
    };
    project(Projection::Perspective, "perspective", tr("Perspective"));
    project(Projection::Orthographic, "orthographic", tr("Orthographic"));
    m_camera << add("view.frame", "frame", tr("&Frame the object"), tr("Bring the object back to the middle"), QKeySequence(Qt::Key_F),
                    [this] { m_preview.frame(); })
             << add("view.reset", "reset", tr("&Reset the view"), tr("The camera as it was at first"), QKeySequence(Qt::Key_R),
                    [this] { m_preview.resetView(); });
    m_exposure << add("view.brighter", "brighter", tr("&Brighter"), tr("Exposure half a stop up"), QKeySequence(Qt::Key_E),
                      [this] { m_preview.changeExposure(0.5); })
               << add("view.darker", "darker", tr("&Darker"), tr("Exposure half a stop down"), QKeySequence(Qt::SHIFT | Qt::Key_E),
                      [this] { m_preview.changeExposure(-0.5); })
               << add("view.exposureReset", "reset", tr("Reset e&xposure"), tr("Exposure back to 0 EV"), QKeySequence(Qt::Key_0),
                      [this] { m_preview.resetExposure(); });
}

void ViewActions::makeBackground()
{
    const auto stand = [this](Backdrop kind, const char* iconName, const QString& text) {
        addChoice(
            m_background, iconName, iconName, text, {}, tr("Change background"),
            [kind](Scene& scene) { scene.view.background.kind = kind; },
            [kind](const Scene& scene) { return scene.view.background.kind == kind; });
    };
    stand(Backdrop::Environment, "background-environment", tr("Environment"));
    stand(Backdrop::Blurred, "background-blurred", tr("Environment, blurred"));
    stand(Backdrop::Color, "background-color", tr("One color"));
    stand(Backdrop::None, "background-none", tr("None"));
}

void ViewActions::makeComparison()
{
    m_snapshot = add("compare.snapshot", "snapshot", tr("Keep a &snapshot"), tr("Keep this material and light to compare with"),
                     QKeySequence(Qt::CTRL | Qt::Key_K), [this] { m_preview.takeSnapshot(); });
    m_compare.setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    const auto compare = [this](Comparison comparison, const char* id, const char* iconName, const QString& text, const QString& help,
                                const QKeySequence& key) {
        QAction* action = add(id, iconName, text, help, key, [this, comparison] {
            m_preview.setComparison(m_preview.comparison() == comparison ? Comparison::Off : comparison);
        });
        action->setCheckable(true);
        m_compare.addAction(action);
        const auto show = [this, action, comparison] {
            action->setEnabled(m_preview.hasSnapshot());
            action->setChecked(m_preview.comparison() == comparison);
        };
        connect(&m_preview, &PreviewWidget::comparisonChanged, this, show);
        show();
    };
    compare(Comparison::Hold, "compare.show", "compare-hold", tr("S&how the snapshot"), tr("Show the snapshot; hold B to glance at it"),
            {});
    compare(Comparison::Wipe, "compare.wipe", "compare-wipe", tr("&Wipe"), tr("Snapshot on the left, now on the right; drag the line"),
            QKeySequence(Qt::Key_W));
    compare(Comparison::SideBySide, "compare.side", "compare-side", tr("Si&de by side"),
            tr("Snapshot on the left and now on the right, each whole"), QKeySequence(Qt::Key_S));
    compare(Comparison::Difference, "compare.difference", "compare-difference", tr("&Difference"),
            tr("Difference to the snapshot, four times as bright"), QKeySequence(Qt::Key_D));
}

/// One of several habits of the hand, not of the scene: it is kept with the settings and not undone.
void ViewActions::addHabit(QActionGroup& group, const QString& id, const char* iconName, const QString& text, const QString& help,
                           std::function<void()> use)
{
    const QString key = QStringLiteral("preview/%1Gesture").arg(id.section(u'.', 0, 0));
    QAction* action = add(id.toLatin1().constData(), iconName, text, help, {}, [use, key, id] {
        use();
        QSettings().setValue(key, id);
    });
    action->setCheckable(true);
    group.addAction(action);
    const bool isKept = QSettings().value(key).toString() == id;
    if (isKept)
        use();
    action->setChecked(isKept || group.actions().size() == 1); // the first is what it is at first
}

void ViewActions::makeHabits()
{
    const auto turn = [&](TurnGesture gesture, const char* id, const QString& text) {
        addHabit(m_turn, QLatin1String(id), "background-environment", text, tr("Dragging so turns the environment"),
                 [this, gesture] { m_preview.setTurnGesture(gesture); });
    };
    turn(TurnGesture::ShiftRight, "turn.shift-right", tr("Shift and right drag"));
    turn(TurnGesture::ControlLeft, "turn.control-left", tr("Ctrl and left drag"));
    turn(TurnGesture::ControlMiddle, "turn.control-middle", tr("Ctrl and middle drag"));
    for (const MousePreset& preset : mousePresets)
        addHabit(m_mouse, QStringLiteral("mouse.") + QLatin1String(preset.id), "view",
                 QCoreApplication::translate("MousePresets", preset.title), tr("Dragging so moves the camera"),
                 [this, &preset] { m_preview.setMousePreset(preset); });
}

// How somebody works, too.
void ViewActions::makeInspection()
{
    const QString key = QStringLiteral("preview/inspect");
    PictureInspector& inspector = m_preview.inspector();
    inspector.setInspections(Inspections::fromInt(QSettings().value(key).toUInt()));
    const auto inspect = [&](Inspect what, const char* id, const char* iconName, const QString& text, const QString& help,
                             Qt::Key shortcut) {
        QAction* action = add(id, iconName, text, help, QKeySequence(shortcut), [&inspector, what, key] {
            inspector.setInspections(inspector.inspections() ^ what);
            QSettings().setValue(key, inspector.inspections().toInt());
        });
        action->setCheckable(true);
        action->setChecked(inspector.inspections().testFlag(what));
        m_inspect << action;
    };
    inspect(Inspect::Values, "inspect.values", "eyedropper", tr("Pixel &values"),
            tr("Tell the light, display value, direction and level of the pixel under the mouse"), Qt::Key_I);
    inspect(Inspect::Histogram, "inspect.histogram", "report", tr("&Histogram"), tr("Show how often each display value occurs"), Qt::Key_H);
    inspect(Inspect::Clipping, "inspect.clipping", "warning", tr("&Clipping"),
            tr("Mark where exposed light is above 1, red, or below 0, blue"), Qt::Key_C);
}

void ViewActions::addTo(QMenu& menu)
{
    const auto submenu = [&](const QString& title, const QList<QAction*>& actions) { menu.addMenu(title)->addActions(actions); };
    submenu(tr("&Geometry"), m_geometry.actions());
    submenu(tr("&Shading"), m_shading.actions());
    menu.addAction(m_lookup);
    submenu(tr("&Projection"), m_projection.actions());
    submenu(tr("&Background"), m_background.actions());
    submenu(tr("&Compare"), QList<QAction*>{m_snapshot} + m_compare.actions());
    submenu(tr("&Inspect"), m_inspect);
    submenu(tr("&Move the camera by"), m_mouse.actions());
    submenu(tr("&Turn the environment by"), m_turn.actions());
    menu.addSeparator();
    menu.addActions(m_camera);
    menu.addActions(m_exposure);
}

void ViewActions::addTo(QToolBar& bar)
{
    const auto list = [&](const char* id, const QString& name, const QString& help, QActionGroup& group) {
        auto* button = new QToolButton(&bar);
        auto* menu = new QMenu(button);
        menu->addActions(group.actions());
        button->setMenu(menu);
        button->setPopupMode(QToolButton::InstantPopup);
        button->setObjectName(QLatin1String(id));
        button->setAccessibleName(name);
        button->setToolTip(help);
        button->setFocusPolicy(Qt::TabFocus);
        const auto show = [button, &group] {
            if (const QAction* chosen = group.checkedAction())
                button->setIcon(chosen->icon());
        };
        connect(&m_workspace.document, &Document::changed, button, show, Qt::QueuedConnection);
        show();
        bar.addWidget(button);
    };
    bar.addActions(m_geometry.actions());
    bar.addSeparator();
    list("bar.shading", tr("Shading"), tr("What the picture shows: the material, or what it is computed from"), m_shading);
    list("bar.projection", tr("Projection"), tr("Perspective or orthographic"), m_projection);
    list("bar.background", tr("Background"), tr("What stands behind the object"), m_background);
    bar.addSeparator();
    bar.addActions(m_camera);
    bar.addActions(m_exposure);
    bar.addSeparator();
    bar.addAction(m_snapshot);
    bar.addActions(m_compare.actions());
    bar.addSeparator();
    bar.addActions(m_inspect);
}

void ViewActions::refresh()
{
    for (const auto& [action, isOn] : m_choices)
        action->setChecked(isOn(m_workspace.document.scene()));
}

} // namespace mirrorball::studio
