#include "map_panel_test.h"

#include "patience.h"
#include "widget_driver.h"

#include "core/image/map_picture.h"
#include "widgets/controls/images.h"
#include "widgets/panels/map_panel.h"

#include <QSignalSpy>
#include <QSlider>
#include <QWheelEvent>

#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<MapPanelTest> registered;

namespace {

/// A panel on the screen, over a scene whose maps are made.
struct ShownPanel {
    explicit ShownPanel(const Scene& scene = small(), const QSize& size = {480, 640})
    {
        workspace.document.reset(scene);
        panel = std::make_unique<MapPanel>(workspace);
        panel->resize(size);
        panel->show();
        isReady = QTest::qWaitForWindowExposed(panel.get()) && settle();
    }
    static Scene small()
    {
        Scene scene;
        scene.probe.source = "builtin:cube-room";
        scene.map.size = 64;
        return scene;
    }
    bool settle()
    {
        return QTest::qWaitFor(
            [&] { return workspace.live.isUpToDate() && panel->view().isUpToDate() && !panel->view().picture().isNull(); }, patience);
    }
    template <typename T>
    T* find(const char* name)
    {
        return panel->findChild<T*>(QLatin1String(name));
    }
    void choose(const char* combo, int value)
    {
        auto* box = find<QComboBox>(combo);
        box->setCurrentIndex(box->findData(value));
        emit box->activated(box->currentIndex());
    }

    Workspace workspace;
    std::unique_ptr<MapPanel> panel;
    bool isReady = false;
};

} // namespace

void MapPanelTest::showsThePictureThatCoreDraws()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    const MapView& view = shown.panel->view();
    QCOMPARE(view.window().layout.kind, Parameterization::Cube);
    const QImage expected = toQImage(windowColors(mapWindow(buildMipPyramid(*view.map()), view.window()), view.coloring()));
    QCOMPARE(view.picture(), expected);
    keepScreenshot(*shown.panel, QStringLiteral("map"));
}

void MapPanelTest::choosesTheParameterizationOfTheSceneAsAnUndoStep()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    for (const Parameterization kind : allParameterizations) {
        shown.choose("map.parameterization", static_cast<int>(kind));
        QCOMPARE(shown.workspace.document.scene().map.parameterization, kind);
        QCOMPARE(shown.panel->view().window().layout.kind, kind); // at once
        QVERIFY(shown.settle());
    }
    QCOMPARE(shown.workspace.document.undoStack().count(), 6); // latlong ... octahedral; it began with a cube
    shown.find<QSpinBox>("map.size")->setValue(128);
    QCOMPARE(shown.workspace.document.scene().map.size, 128);
    while (shown.workspace.document.undoStack().canUndo())
        shown.workspace.document.undoStack().undo();
    QVERIFY(shown.workspace.document.scene().map == ShownPanel::small().map);
    QCOMPARE(shown.find<QComboBox>("map.parameterization")->currentData().toInt(), static_cast<int>(Parameterization::Cube));
    QCOMPARE(shown.find<QSpinBox>("map.size")->value(), 64);
}

void MapPanelTest::showsEveryStageOrSaysWhyThereIsNone()
{
    Scene scene = ShownPanel::small();
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    scene.map.mips = true;
    ShownPanel shown(scene);
    QVERIFY(shown.isReady);
    shown.panel->showStage(MapStage::Specular);
    QVERIFY(shown.settle());
    QVERIFY(shown.panel->view().map() != nullptr);
    auto* level = shown.find<QSpinBox>("map.level");
    QVERIFY(level->isVisible());
    level->setValue(2);
    QVERIFY(shown.settle());
    QCOMPARE(shown.panel->view().map()->layout.size, shown.workspace.live.made()->maps.specular->at(2).layout.size);

    shown.panel->showStage(MapStage::Diffuse);
    QVERIFY(shown.panel->view().map() == nullptr);
    QVERIFY2(shown.panel->view().message().contains(QStringLiteral("diffuse weight is 0")), qPrintable(shown.panel->view().message()));
    keepScreenshot(*shown.panel, QStringLiteral("map-left-out"));
    shown.workspace.document.edit(QStringLiteral("diffuse"), {}, [](Scene& s) { s.material.diffuse.weight = 1.0; });
    QVERIFY(shown.settle());
    QTRY_VERIFY(shown.panel->view().map() != nullptr);

    shown.panel->showStage(MapStage::Error);
    QVERIFY(shown.panel->view().message().contains(QStringLiteral("Report")));
}

void MapPanelTest::readsLinearValuesAndTheDirectionUnderTheMouse()
{
    Scene scene = ShownPanel::small();
    scene.map.parameterization = Parameterization::Latlong; // the probe's own: texels are read as they are
    ShownPanel shown(scene);
    QVERIFY(shown.isReady);
    MapView& view = shown.panel->view();
    const EnvironmentMap& probe = *view.map();
    const glm::dvec3 d = texelDirection(probe.layout, 300, 200);
    QSignalSpy moved(&shown.workspace.cursor, &DirectionCursor::moved);
    QTest::mouseMove(&view, view.positionOf(d).toPoint());
    QTRY_VERIFY(!moved.isEmpty());
    QVERIFY(glm::length(*shown.workspace.cursor.direction() - d) < 0.02); // within a pixel of the reduced picture
    const glm::dvec2 p = coordinate(probe.layout, *shown.workspace.cursor.direction());
    const float* texel = probe.image.texel(static_cast<int>(p.x), static_cast<int>(p.y));
    QVERIFY2(shown.panel->readout().contains(shortNumberText(texel[1])), qPrintable(shown.panel->readout()));
    keepScreenshot(*shown.panel, QStringLiteral("map-readout"));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&view, &leave);
    QVERIFY(!shown.workspace.cursor.direction());
}

void MapPanelTest::marksTheDirectionThatIsPointedAtElsewhere()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    MapView& view = shown.panel->view();
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
    const QImage before = view.grab().toImage();
    shown.workspace.cursor.set(d);
    const QImage after = view.grab().toImage();
    const QPoint at = (view.positionOf(d) * view.devicePixelRatioF()).toPoint();
    QRect changed;
    for (int y = 0; y < after.height(); ++y)
        for (int x = 0; x < after.width(); ++x)
            if (before.pixel(x, y) != after.pixel(x, y))
                changed |= QRect(x, y, 1, 1);
    QVERIFY(changed.contains(at));
    QVERIFY(changed.width() < 24 * view.devicePixelRatioF());
    const auto back = view.directionAt(view.positionOf(d));
    QVERIFY(back && glm::length(*back - d) < 1e-6);
}

void MapPanelTest::zoomsWhereTheMouseIsAndFits()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    MapView& view = shown.panel->view();
    const MapWindow fitted = view.window();
    const QPointF at = view.positionOf(glm::normalize(glm::dvec3(0.2, 0.1, 1.0)));
    const auto before = view.directionAt(at);
    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 720}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);
    QVERIFY(view.window().scale > 2.0 * fitted.scale);
    QVERIFY(glm::length(*view.directionAt(at) - *before) < 1e-6); // what the mouse points at stays under it
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseMove(&view, QPoint(130, 110));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(130, 110));
    QVERIFY(shown.settle());
    keepScreenshot(*shown.panel, QStringLiteral("map-zoomed"));
    QTest::mouseDClick(&view, Qt::LeftButton);
    QCOMPARE(view.window().scale, fitted.scale);
    QCOMPARE(view.window().origin.x, fitted.origin.x);
}

void MapPanelTest::isDrivenByKeys()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    MapView& view = shown.panel->view();
    view.setFocus();
    const double scale = view.zoom();
    QTest::keyClick(&view, Qt::Key_Plus);
    QVERIFY(view.zoom() > scale);
    const double origin = view.window().origin.x;
    QTest::keyClick(&view, Qt::Key_Right);
    QVERIFY(view.window().origin.x > origin);
    QTest::keyClick(&view, Qt::Key_1);
    QCOMPARE(view.zoom(), 1.0);
    QTest::keyClick(&view, Qt::Key_0);
    QCOMPARE(view.zoom(), scale);
    shown.workspace.cursor.set(texelDirection(view.window().layout, 10, 10));
    QTest::keyClick(&view, Qt::Key_Right, Qt::ShiftModifier);
    const glm::dvec2 p = coordinate(view.window().layout, *shown.workspace.cursor.direction());
    QCOMPARE(static_cast<int>(p.x), 11);
    QCOMPARE(static_cast<int>(p.y), 10);
}

void MapPanelTest::showsAFalseColorScaleThatFollowsTheExposure()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    shown.choose("map.colors", static_cast<int>(MapColors::Luminance));
    QVERIFY(shown.settle());
    const MapColoring before = shown.panel->view().coloring();
    QCOMPARE(before.colors, MapColors::Luminance);
    auto* exposure = shown.find<NumberField>("map.exposure");
    exposure->box()->setValue(1.0);
    emit exposure->edited(1.0);
    QVERIFY(std::abs(shown.panel->view().coloring().high - 0.5 * before.high) < 1e-9);
    shown.find<QToolButton>("map.grid")->click();
    shown.find<QToolButton>("map.seams")->click();
    shown.choose("map.tint", static_cast<int>(MapTint::SolidAngle));
    QVERIFY(shown.settle());
    keepScreenshot(*shown.panel, QStringLiteral("map-overlays"));
    QVERIFY(shown.panel->view().overlays().grid && shown.panel->view().overlays().seams);
}

void MapPanelTest::showsTwoParameterizationsAndTheirDifference()
{
    ShownPanel shown(ShownPanel::small(), {480, 860});
    QVERIFY(shown.isReady);
    shown.choose("map.compare", static_cast<int>(Parameterization::Paraboloid));
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->differenceView().map() != nullptr, patience);
    QVERIFY(shown.settle());
    QTRY_VERIFY(shown.panel->differenceView().isUpToDate() && shown.panel->otherView().isUpToDate());
    const EnvironmentMap& a = *shown.panel->view().map();
    const EnvironmentMap& b = *shown.panel->otherView().map();
    QCOMPARE(b.layout.kind, Parameterization::Paraboloid);
    const double texels = static_cast<double>(b.image.width) * b.image.height / (static_cast<double>(a.image.width) * a.image.height);
    QVERIFY(texels > 0.9 && texels < 1.1);
    QVERIFY(shown.panel->differenceView().map()->image == difference(a, b).image);
    keepScreenshot(*shown.panel, QStringLiteral("map-compare"));
    shown.panel->resize(1200, 560);
    QTest::qWait(300);
    QVERIFY(shown.settle());
    keepScreenshot(*shown.panel, QStringLiteral("map-compare-wide"));
    shown.choose("map.compare", -1);
    QVERIFY(!shown.panel->differenceView().isVisible());
}

void MapPanelTest::showsTheErrorOfAMethod()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    EnvironmentMap error(MapLayout{Parameterization::Cube, 8, 0});
    error.image.texels[0] = -0.25f;
    shown.workspace.methodError.show(std::make_shared<const EnvironmentMap>(error), QStringLiteral("importance, 256 samples"));
    QCOMPARE(shown.panel->stage(), MapStage::Error);
    QVERIFY(shown.settle());
    QCOMPARE(shown.panel->view().coloring().colors, MapColors::Signed);
}

void MapPanelTest::namesAllControls()
{
    ShownPanel shown;
    const QStringList names = unexplained(*shown.panel);
    QVERIFY2(names.isEmpty(), qPrintable(names.join(u'\n')));
}

} // namespace mirrorball::test
