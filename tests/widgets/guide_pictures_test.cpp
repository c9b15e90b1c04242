#include "guide_pictures_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/map_picture.h"
#include "core/scene/material_presets.h"
#include "core/spheremap/document/presets.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/panels/map_panel.h"
#include "widgets/spheremap/sphere_map_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QToolButton>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<GuidePicturesTest> registered;

void GuidePicturesTest::init() { QSettings().clear(); }

namespace {

constexpr QSize windowSize{1440, 900};

void showWindow(StudioWindow& window)
{
    window->resize(windowSize);
    window.show();
    window->resize(windowSize);
}

void apply(StudioWindow& window, const char* material)
{
    window.document().edit(QStringLiteral("material"), {},
                           [material](Scene& scene) { scene.material = findMaterialPreset(material)->material; });
    window.document().finishEdit();
}

void front(StudioWindow& window, const char* dock)
{
    QDockWidget* widget = window->dock(QLatin1String(dock));
    widget->show();
    widget->raise();
    QTRY_VERIFY(widget->widget()->isVisible());
}

/// The picture at rest, what stands beside it, and all thumbnails.
void keep(StudioWindow& window, const char* name)
{
    window.waitForPicture();
    QTest::qWait(300);
    window.waitForPicture();
    keepScreenshot(*window, QLatin1String(name));
}

} // namespace

void GuidePicturesTest::studio()
{
    StudioWindow window;
    showWindow(window);
    apply(window, "car-paint");
    front(window, "map");
    front(window, "plan");
    front(window, "material");
    keep(window, "studio");
}

void GuidePicturesTest::map()
{
    Scene scene;
    scene.probe.source = "builtin:cube-room";
    scene.map.size = 64;
    Workspace workspace;
    workspace.document.reset(scene);
    MapPanel panel(workspace);
    panel.resize(480, 640);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const auto choose = [&](const char* name, auto value) {
        auto* box = panel.findChild<QComboBox*>(QLatin1String(name));
        box->setCurrentIndex(box->findData(static_cast<int>(value)));
        emit box->activated(box->currentIndex());
    };
    choose("map.tint", MapTint::SolidAngle);
    for (const char* overlay : {"map.grid", "map.seams"}) {
        auto* button = panel.findChild<QToolButton*>(QLatin1String(overlay));
        QVERIFY2(button, overlay);
        button->setChecked(true);
    }
    QTRY_VERIFY_WITH_TIMEOUT(workspace.live.isUpToDate() && panel.view().isUpToDate() && !panel.view().picture().isNull(), 60000);
    QTest::qWait(100);
    keepScreenshot(panel, QStringLiteral("studio-map"));
}

void GuidePicturesTest::exports()
{
    StudioWindow window;
    showWindow(window);
    window->findChild<QAction*>(QStringLiteral("file.export"))->trigger();
    auto* dialog = window->findChild<ExportDialog*>();
    QVERIFY(dialog);
    dialog->setFolder(QStringLiteral("/home/artist/maps"));
    QTRY_VERIFY_WITH_TIMEOUT(dialog->isEstimated(), 60000);
    QTest::qWait(100);
    keepScreenshot(*dialog, QStringLiteral("studio-export"));
}

void GuidePicturesTest::sphereMap()
{
    StudioWindow window;
    showWindow(window);
    const SphereMapPreset* preset = findSphereMapPreset("three-lights");
    QVERIFY(preset);
    SphereMapEditor& editor = window->workspace().sphereMap;
    editor.setMap(QStringLiteral("lights"), preset->document);
    front(window, "sphere-map");
    QTRY_VERIFY_WITH_TIMEOUT(editor.isUpToDate(), 60000);
    keep(window, "studio-sphere-map");
}

void GuidePicturesTest::comparison()
{
    StudioWindow window;
    showWindow(window);
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_K, Qt::ControlModifier);
    window->workspace().snapshots.rename(0, QStringLiteral("mirror"));
    apply(window, "gold");
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_S);
    front(window, "snapshots");
    window.waitForPicture();
    QTRY_VERIFY_WITH_TIMEOUT(window->workspace().snapshots.error().has_value(), 60000);
    keep(window, "studio-compare");
}

} // namespace mirrorball::test
