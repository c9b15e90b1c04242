#include "sphere_map_panel_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "widgets/controls/text.h"
#include "widgets/picture/model_painter.h"
#include "widgets/spheremap/sphere_map_panel.h"

#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/strokes/stroke_raster.h"

#include <QDir>
#include <QDockWidget>
#include <QPointingDevice>
#include <QSettings>
#include <QSignalSpy>
#include <QTabletEvent>

#include <cmath>
#include <fstream>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<SphereMapPanelTest> registered;

void SphereMapPanelTest::init() { QSettings().clear(); }

void SphereMapPanelTest::offersAWayToStartWithoutAMap()
{
    Painting painting(false);
    QVERIFY(painting.panel().findChild<QWidget*>(QStringLiteral("newSphereMap"))->isVisible());
    QVERIFY(!painting.canvas().isVisible());
    QTest::mouseClick(painting.panel().findChild<QWidget*>(QStringLiteral("newSphereMap")), Qt::LeftButton);
    QVERIFY(painting.canvas().isVisible());
    QCOMPARE(painting.editor().map()->layers.size(), size_t{2});
    painting.document().undoStack().undo();
    QVERIFY(!painting.canvas().isVisible());
}

void SphereMapPanelTest::drawsAStrokeByMouseAsOneUndoStep()
{
    Painting painting;
    const int before = painting.steps();
    painting.drag(painting.at(-0.5, 0.0), painting.at(0.5, 0.2));
    QCOMPARE(painting.steps(), before + 1);
    QCOMPARE(painting.strokes().size(), size_t{1});
    const Stroke& stroke = painting.strokes()[0];
    const double texel = 1.5 / 100; // places are whole pixels of the widget
    QVERIFY(glm::distance(stroke.points.front().q, glm::dvec2(-0.5, 0.0)) < texel);
    QVERIFY(glm::distance(stroke.points.back().q, glm::dvec2(0.5, 0.2)) < texel);
    painting.drag(painting.at(0.0, -0.5), painting.at(0.3, -0.5));
    QCOMPARE(painting.strokes().size(), size_t{2});
    painting.document().undoStack().undo();
    QCOMPARE(painting.strokes().size(), size_t{1});
    painting.document().undoStack().redo();
    QCOMPARE(painting.strokes().size(), size_t{2});
}

void SphereMapPanelTest::showsTheStrokeWhileItIsDrawnAsTheFileWillHoldIt()
{
    Painting painting;
    QTest::mousePress(&painting.canvas(), Qt::LeftButton, {}, painting.at(-0.4, 0.0));
    const QPointF to = painting.at(0.4, 0.0);
    QMouseEvent move(QEvent::MouseMove, to, painting.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&painting.canvas(), &move);
    painting.waitForPicture();
    const Image drawing = painting.editor().picture();
    QVERIFY(painting.strokes().empty());
    QVERIFY(drawing != evaluate(*painting.editor().map(), {.size = painting.editor().size()}));
    QTest::mouseRelease(&painting.canvas(), Qt::LeftButton, {}, painting.at(0.4, 0.0));
    painting.waitForPicture();
    QVERIFY(painting.editor().picture() == evaluate(*painting.editor().map(), {.size = painting.editor().size()}));
    painting.document().undoStack().undo();
    painting.waitForPicture();
    QVERIFY(painting.editor().picture() == evaluate(*painting.editor().map(), {.size = painting.editor().size()}));
}

void SphereMapPanelTest::takesAPensPressureAndItsEraserEnd()
{
    Painting painting;
    using End = QPointingDevice::PointerType;
    painting.pen(QEvent::TabletPress, painting.at(0.0, 0.0), 0.25, End::Pen);
    painting.pen(QEvent::TabletMove, painting.at(0.2, 0.0), 0.5, End::Pen);
    painting.pen(QEvent::TabletMove, painting.at(0.4, 0.0), 0.75, End::Pen);
    painting.pen(QEvent::TabletRelease, painting.at(0.4, 0.0), 0.0, End::Pen);
    QCOMPARE(painting.strokes().size(), size_t{1});
    QCOMPARE(painting.strokes()[0].points.front().pressure, 0.25);
    QCOMPARE(painting.strokes()[0].points.back().pressure, 0.75);
    QVERIFY(painting.strokes()[0].brush.mode == BrushMode::Paint);
    painting.pen(QEvent::TabletPress, painting.at(0.0, 0.0), 1.0, End::Eraser);
    painting.pen(QEvent::TabletRelease, painting.at(0.0, 0.0), 0.0, End::Eraser);
    QCOMPARE(painting.strokes().size(), size_t{2});
    QVERIFY(painting.strokes()[1].brush.mode == BrushMode::Erase);
}

void SphereMapPanelTest::takesAPensTiltWhereTheBrushHeedsIt()
{
    Painting painting;
    const auto draw = [&](const QPointF& tiltDeg) {
        using End = QPointingDevice::PointerType;
        painting.pen(QEvent::TabletPress, painting.at(0.0, 0.0), 1.0, End::Pen, tiltDeg);
        painting.pen(QEvent::TabletMove, painting.at(0.4, 0.0), 1.0, End::Pen, tiltDeg);
        painting.pen(QEvent::TabletRelease, painting.at(0.4, 0.0), 0.0, End::Pen, tiltDeg);
        return painting.strokes().back();
    };
    const Stroke upright = draw({});
    QVERIFY(draw({30.0, 45.0}) == upright); // the brush does not, at first
    auto* heed = painting.panel().findChild<QWidget*>(QStringLiteral("brushForm"))->findChild<NumberField*>(QStringLiteral("tilt"));
    QVERIFY(heed);
    heed->box()->setValue(1.0);
    const Stroke tilted = draw({30.0, 45.0});
    QCOMPARE(tilted.brush.tilt, 1.0);
    for (const StrokePoint& point : tilted.points)
        QCOMPARE(point.tilt, glm::dvec2(30.0, -45.0)); // Qt's y goes down
    QVERIFY(texelStroke(tilted, 256).bounds.height() > texelStroke(upright, 256).bounds.height());
}

void SphereMapPanelTest::steadiesTheHandByAStringAndRemembersItsLength()
{
    Painting painting;
    auto* stabilizer = painting.panel().findChild<NumberField*>(QStringLiteral("stabilizer"));
    QVERIFY(stabilizer);
    const QPoint from = painting.at(-0.5, 0.0), to = painting.at(0.5, 0.0);
    const auto end = [&] { return painting.canvas().placeOf(painting.strokes().back().points.back().q) - QPointF(to); };
    painting.drag(from, to);
    const Stroke plain = painting.strokes().back();
    QVERIFY(end().manhattanLength() < 0.1);
    stabilizer->box()->setValue(30.0);
    painting.drag(from, to);
    QVERIFY2(std::abs(end().x() + 30.0) < 0.1 && std::abs(end().y()) < 0.1, qPrintable(QString::number(end().x())));
    QCOMPARE(keptStabilizer(), 30.0); // what the next window begins with
    painting.drag(from, from + QPoint(20, 0));
    QCOMPARE(painting.strokes().back().points.size(), size_t{1}); // the string was never taut
    stabilizer->reset();
    painting.drag(from, to);
    QVERIFY(painting.strokes().back() == plain);
}

void SphereMapPanelTest::repeatsStrokesBySymmetry()
{
    Painting painting;
    auto* radial = painting.panel().findChild<QSpinBox*>(QStringLiteral("radial"));
    QVERIFY(radial);
    radial->setValue(6);
    painting.drag(painting.at(0.2, 0.0), painting.at(0.6, 0.0));
    QCOMPARE(painting.strokes()[0].symmetry.radial, 6);
}

void SphereMapPanelTest::picksColorsFromTheDisc()
{
    Painting painting;
    Brush brush;
    brush.color = {0.0, 0.5, 1.0};
    brush.hardness = 1.0;
    brush.flow = 1.0;
    painting.editor().setBrush(brush);
    painting.drag(painting.at(0.0, 0.0), painting.at(0.1, 0.0));
    painting.waitForPicture();
    brush.color = {1.0, 0.0, 0.0};
    painting.editor().setBrush(brush);
    const int before = painting.steps();
    QTest::mouseClick(&painting.canvas(), Qt::LeftButton, Qt::AltModifier, painting.at(0.05, 0.0));
    QCOMPARE(painting.editor().brush().color, glm::dvec3(0.0, 0.5, 1.0));
    QCOMPARE(painting.steps(), before); // a brush is no part of the document
}

void SphereMapPanelTest::changesTheBrushByARightDrag()
{
    Painting painting;
    const Brush before = painting.editor().brush();
    painting.drag(painting.at(0.0, 0.0), painting.at(0.0, 0.0) + QPoint(60, -50), Qt::RightButton);
    QVERIFY(painting.editor().brush().radius > 1.4 * before.radius);
    QVERIFY(painting.editor().brush().hardness > before.hardness);
    QVERIFY(painting.strokes().empty());
    QTest::keyClick(&painting.canvas(), Qt::Key_BracketLeft);
    QVERIFY(painting.editor().brush().radius < 1.6 * before.radius);
}

void SphereMapPanelTest::refusesToPaintOnAnotherLayerInWords()
{
    Painting painting;
    painting.editor().choose(0);
    const int before = painting.steps();
    painting.drag(painting.at(0.0, 0.0), painting.at(0.3, 0.0));
    QCOMPARE(painting.steps(), before);
    QVERIFY(!painting.editor().paintingProblem().isEmpty());
}

void SphereMapPanelTest::givesUpAStrokeByEscape()
{
    Painting painting;
    const int before = painting.steps();
    QTest::mousePress(&painting.canvas(), Qt::LeftButton, {}, painting.at(0.0, 0.0));
    QTest::keyClick(&painting.canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&painting.canvas(), Qt::LeftButton, {}, painting.at(0.0, 0.0));
    QCOMPARE(painting.steps(), before);
    QVERIFY(!painting.editor().isPainting());
}

void SphereMapPanelTest::showsTheLevels()
{
    Painting painting;
    painting.panel().tabs().setCurrentIndex(2);
    LevelsView& levels = painting.panel().levels();
    QTRY_VERIFY_WITH_TIMEOUT(!levels.levels().isEmpty(), 20000);
    QCOMPARE(levels.levels().first().size, painting.document().scene().material.sphereMap.size);
    QCOMPARE(levels.levels().size(), 11); // 1024 to 1
    QCOMPARE(levels.levels().last().size, 1);
}

void SphereMapPanelTest::opensAndSavesFilesAndTellsWhatIsWrong()
{
    const TemporaryFolder folder;
    Painting painting;
    painting.drag(painting.at(-0.2, 0.0), painting.at(0.2, 0.0));
    painting.panel().saveMapAs(fromPath(folder / "a.spheremap"));
    QCOMPARE(loadSphereMap(folder / "a.spheremap").layers, painting.editor().map()->layers);
    std::ofstream(folder / "bad.spheremap") << "{\"version\": 1, \"layers\": [7]}";
    painting.panel().openMap(fromPath(folder / "bad.spheremap"));
    const auto& notices = painting.window()->workspace().notices.all();
    QVERIFY(!notices.isEmpty() && notices.last().text.contains(QStringLiteral("bad.spheremap")));
    QCOMPARE(painting.editor().map()->layers.size(), size_t{2});
    painting.panel().openMap(fromPath(folder / "a.spheremap"));
    QCOMPARE(painting.strokes().size(), size_t{1});
}

void SphereMapPanelTest::paintsOnTheModel()
{
    Painting painting;
    painting.editor().setPaintsOnModel(true);
    painting.window().waitForPicture();
    PreviewWidget& preview = painting.window().preview();
    auto* painter = preview.findChild<ModelPainter*>();
    QVERIFY(painter);
    const QPoint middle(preview.width() / 2, preview.height() / 2);
    const std::optional<glm::dvec2> q = painter->placeAt(middle);
    QVERIFY(q.has_value());
    QVERIFY(!painter->placeAt({2, 2}).has_value());
    const CameraSettings camera = painting.document().scene().view.camera;
    Painting::drag(&preview, middle, middle + QPoint(12, 0));
    QCOMPARE(painting.strokes().size(), size_t{1});
    QVERIFY(glm::distance(painting.strokes()[0].points.front().q, *q) < 1e-4);
    QVERIFY(painting.document().scene().view.camera == camera);
    Painting::drag(&preview, middle, middle + QPoint(30, 0), Qt::LeftButton, Qt::AltModifier);
    QVERIFY(painting.document().scene().view.camera != camera);
    QCOMPARE(painting.strokes().size(), size_t{1});
}

void SphereMapPanelTest::steadiesTheHandOnTheModelToo()
{
    Painting painting;
    painting.editor().setPaintsOnModel(true);
    painting.editor().setStabilizer(12.5);
    painting.window().waitForPicture();
    PreviewWidget& preview = painting.window().preview();
    auto* painter = preview.findChild<ModelPainter*>();
    QVERIFY(painter);
    const QPoint middle(preview.width() / 2, preview.height() / 2);
    const std::optional<glm::dvec2> end = painter->placeAt(QPointF(middle) + QPointF(11.5, 0.0));
    QVERIFY(end.has_value());
    Painting::drag(&preview, middle, middle + QPoint(24, 0));
    QCOMPARE(painting.strokes().size(), size_t{1});
    QVERIFY(glm::distance(painting.strokes()[0].points.back().q, *end) < 1e-4);
}

/// Before it is part of the document, and as it will look when it is.
void SphereMapPanelTest::theModelShowsAStrokeWhileItIsDrawn()
{
    Painting painting;
    PreviewWidget& preview = painting.window().preview();
    preview.setSamplesWhileDragging(4); // as at rest, so that the two can be compared
    const auto shown = [&preview] {
        QImage picture = preview.picture().convertToFormat(QImage::Format_RGB888);
        picture.setDevicePixelRatio(1.0);
        return picture;
    };
    const QImage before = painting.window().picture();
    QTest::mousePress(&painting.canvas(), Qt::LeftButton, {}, painting.at(-0.4, 0.0));
    for (int i = 1; i <= 40; ++i) { // what is shown ends half a movement behind the pen
        const QPointF to = painting.at(-0.4 + 0.02 * i, 0.0);
        QMouseEvent move(QEvent::MouseMove, to, painting.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&painting.canvas(), &move);
    }
    painting.waitForPicture();
    QTRY_VERIFY_WITH_TIMEOUT(preview.isUpToDate() && largestDifference(shown(), before) > 20, 10000);
    QVERIFY(painting.strokes().empty());
    const QImage during = shown();
    QTest::mouseRelease(&painting.canvas(), Qt::LeftButton, {}, painting.at(0.4, 0.0));
    painting.waitForPicture();
    const QImage after = painting.window().picture();
    QVERIFY2(largestDifference(after, during) < largestDifference(during, before) / 2,
             qPrintable(QString::number(largestDifference(after, during)) + u' ' + QString::number(largestDifference(during, before))));
}

void SphereMapPanelTest::choosesABrushOnTheModelAsOnTheDisc()
{
    Painting painting;
    painting.editor().setPaintsOnModel(true);
    painting.window().waitForPicture();
    PreviewWidget& preview = painting.window().preview();
    auto* painter = preview.findChild<ModelPainter*>();
    const QPointF middle(preview.width() / 2, preview.height() / 2);
    QMouseEvent hover(QEvent::MouseMove, middle, preview.mapToGlobal(middle), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&preview, &hover);
    QTRY_VERIFY(painter->ring().isVisible());
    // Places on the ring are a radius away on the disc, as far as the model there bends evenly.
    const double radius = painting.editor().brush().radius;
    for (const QPointF& place : painter->ring().outline())
        if (const auto q = painter->placeAt(place))
            QVERIFY2(std::abs(glm::distance(*q, *painter->placeAt(middle)) / radius - 1.0) < 0.5,
                     qPrintable(QString::number(glm::distance(*q, *painter->placeAt(middle)) / radius)));
    Painting::drag(&preview, middle.toPoint(), middle.toPoint() + QPoint(60, -50), Qt::RightButton);
    QVERIFY(painting.editor().brush().radius > 1.4 * radius);
    QVERIFY(painting.strokes().empty());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&preview, &leave);
    QTRY_VERIFY(!painter->ring().isVisible());
}

void SphereMapPanelTest::followsHandMadeLevelsWhileAStrokeIsDrawn()
{
    Painting painting;
    painting.editor().edit({}, {}, [](SphereMapDocument& map) { std::get<PaintLayer>(map.layers[1].content).unit = WidthUnit::Pixels; });
    painting.waitForPicture();
    QSignalSpy levels(&painting.editor(), &SphereMapEditor::levelsChanged);
    QTest::mousePress(&painting.canvas(), Qt::LeftButton, {}, painting.at(-0.4, 0.0));
    const QPointF to = painting.at(0.4, 0.0);
    QMouseEvent move(QEvent::MouseMove, to, painting.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&painting.canvas(), &move);
    painting.waitForPicture();
    QVERIFY(!levels.isEmpty());
    const std::vector<Image> drawing = painting.editor().coarserLevels();
    const std::vector<Image> without = evaluateLevels(*painting.editor().map(), painting.editor().size()); // the stroke is not in it yet
    QCOMPARE(drawing.size() + 1, without.size());
    for (size_t i = 0; i < drawing.size(); ++i) {
        QCOMPARE(drawing[i].width, without[i + 1].width);
        QVERIFY(drawing[i] != without[i + 1]);
    }
    QTest::mouseRelease(&painting.canvas(), Qt::LeftButton, {}, painting.at(0.4, 0.0));
    QCOMPARE(painting.strokes().size(), size_t{1});
}

/// For people to look at: MIRRORBALL_SCREENSHOTS.
void SphereMapPanelTest::looksWell()
{
    Painting painting;
    StudioWindow& window = painting.window();
    QDockWidget* dock = window->dock(QStringLiteral("sphere-map"));
    dock->setFloating(false);
    dock->raise();
    const SphereMapPreset* preset = findSphereMapPreset("enamel");
    painting.editor().setMap({}, preset ? preset->document : sphereMapPresets().front().document);
    painting.editor().addLayer({.name = "Paint", .content = PaintLayer{}});
    painting.editor().setPaintsOnModel(true);
    for (const QSize& size : {QSize(1280, 800), QSize(1820, 1120)}) {
        window->resize(size);
        window.waitForPicture();
        PreviewWidget& preview = window.preview();
        Brush brush = painting.editor().brush();
        brush.color = {1.0, 0.9, 0.3};
        painting.editor().setBrush(brush);
        const QPoint middle(preview.width() / 2, preview.height() / 2);
        Painting::drag(&preview, middle + QPoint(-60, -30), middle + QPoint(50, 10));
        painting.waitForPicture();
        window.waitForPicture();
        QTest::qWait(100);
        const QString name = QStringLiteral("sphere-map-%1").arg(size.width());
        keepScreenshot(*window, name + QStringLiteral("-layers"));
        painting.panel().tabs().setCurrentIndex(1);
        keepScreenshot(*window, name + QStringLiteral("-brush"));
        painting.panel().tabs().setCurrentIndex(2);
        QTRY_VERIFY_WITH_TIMEOUT(!painting.panel().levels().levels().isEmpty(), 20000);
        QTest::qWait(300);
        keepScreenshot(*window, name + QStringLiteral("-levels"));
        painting.panel().tabs().setCurrentIndex(0);
    }
    for (const char* kind : {"phong-lights", "gradient", "colorgram", "probe", "toon"}) {
        painting.editor().addLayer({.content = makeContent(kind), .mask = Mask{}});
        QTest::qWait(100);
        keepScreenshot(painting.panel(), QStringLiteral("panel-%1").arg(QLatin1String(kind)));
    }
}

} // namespace mirrorball::test
