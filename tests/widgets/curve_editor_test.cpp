#include "curve_editor_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "widgets/controls/curve_editor.h"

#include <QSignalSpy>

#include <cmath>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<CurveEditorTest> registered;

namespace {

/// An editor by itself, shown, with the points of a gentle S.
class Curve {
public:
    Curve()
    {
        m_editor.resize(260, 270);
        m_editor.setPoints(CurvesLayer{}.points);
        m_editor.show();
        QApplication::processEvents();
    }
    CurveEditor& editor() { return m_editor; }
    CurvePlot& plot() { return m_editor.plot(); }
    const std::vector<CurvePoint>& points() { return plot().points(); }
    QPoint at(double x, double y) { return plot().placeOf(x, y).toPoint(); }
    double pixel() { return 1.0 / (plot().placeOf(1.0, 0.0).x() - plot().placeOf(0.0, 0.0).x()); }
    void drag(const QPoint& from, const QPoint& to) { Painting::drag(&plot(), from, to); }

private:
    CurveEditor m_editor;
};

} // namespace

void CurveEditorTest::drawsTheCurveThatCoreEvaluates()
{
    Curve curve;
    const std::vector<CurvePoint> points{{0.0, 0.1}, {0.4, 0.8}, {0.7, 0.2}, {1.0, 0.9}};
    curve.editor().setPoints(points);
    const QImage image = curve.plot().grab().toImage();
    const CurveTable table(points);
    for (const double x : {0.13, 0.3, 0.55, 0.9}) { // away from handles
        const QPointF place = curve.plot().placeOf(x, static_cast<double>(table.at(static_cast<float>(x)))) * image.devicePixelRatio();
        int brightest = 0;
        for (int dy = -1; dy <= 1; ++dy)
            brightest = std::max(brightest, qGray(image.pixel(static_cast<int>(place.x()), static_cast<int>(place.y()) + dy)));
        QVERIFY2(brightest > 150, qPrintable(QString::number(x)));
    }
}

void CurveEditorTest::addsAPointOnTheCurveAndDragsItInOneStep()
{
    Curve curve;
    QSignalSpy finished(&curve.editor(), &CurveEditor::finished);
    const double y = static_cast<double>(CurveTable(curve.points()).at(0.5f));
    QTest::mouseClick(&curve.plot(), Qt::LeftButton, {}, curve.at(0.5, y));
    QCOMPARE(curve.points().size(), size_t{5});
    const CurvePoint added = curve.points()[2];
    QVERIFY(std::abs(added.x - 0.5) < curve.pixel());
    QVERIFY(std::abs(added.y - static_cast<double>(CurveTable(CurvesLayer{}.points).at(static_cast<float>(added.x)))) <
            1e-4); // not where the mouse was
    QCOMPARE(finished.size(), 1);
    curve.drag(curve.at(0.1, 0.6), curve.at(0.12, 0.7)); // far from the curve: there
    QCOMPARE(curve.points().size(), size_t{6});
    QCOMPARE(curve.plot().chosen(), 1);
    QVERIFY(std::abs(curve.points()[1].x - 0.12) < curve.pixel() && std::abs(curve.points()[1].y - 0.7) < curve.pixel());
    QCOMPARE(finished.size(), 2);
}

void CurveEditorTest::keepsPointsBetweenTheirNeighbors()
{
    Curve curve;
    curve.drag(curve.at(0.25, 0.19), curve.at(0.95, 0.5));
    QCOMPARE(curve.points().size(), size_t{4});
    QVERIFY(curve.points()[1].x < curve.points()[2].x);
    QVERIFY(std::abs(curve.points()[1].y - 0.5) < curve.pixel());
    curve.drag(curve.at(0.0, 0.0), curve.at(0.0, 0.0) + QPoint(-20, 15)); // outside, but not far
    QCOMPARE(curve.points()[0].x, 0.0);
    QCOMPARE(curve.points()[0].y, 0.0);
}

void CurveEditorTest::removesAPointThatIsPulledAwayAndBringsItBack()
{
    Curve curve;
    curve.drag(curve.at(0.25, 0.19), QPoint(curve.plot().width() + 60, 40));
    QCOMPARE(curve.points().size(), size_t{3});
    curve.editor().setPoints(CurvesLayer{}.points);
    const QPoint start = curve.at(0.25, 0.19);
    QTest::mousePress(&curve.plot(), Qt::LeftButton, {}, start);
    const auto move = [&](const QPoint& to) {
        QMouseEvent event(QEvent::MouseMove, to, curve.plot().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&curve.plot(), &event);
    };
    move(QPoint(-80, 40));
    QCOMPARE(curve.points().size(), size_t{3});
    move(curve.at(0.3, 0.3));
    QTest::mouseRelease(&curve.plot(), Qt::LeftButton, {}, curve.at(0.3, 0.3));
    QCOMPARE(curve.points().size(), size_t{4});
    QVERIFY(std::abs(curve.points()[1].x - 0.3) < curve.pixel());
    for (int i = 0; i < 4; ++i)
        QTest::keyClick(&curve.plot(), Qt::Key_Delete);
    QCOMPARE(curve.points().size(), size_t{2}); // as few as the field allows
}

void CurveEditorTest::followsKeys()
{
    Curve curve;
    QTest::keyClick(&curve.plot(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(curve.plot().chosen(), 1);
    QTest::keyClick(&curve.plot(), Qt::Key_Up);
    QTest::keyClick(&curve.plot(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(curve.points()[1].y - 0.2) < 1e-9 && std::abs(curve.points()[1].x - 0.249) < 1e-9);
    QTest::keyClick(&curve.plot(), Qt::Key_Insert);
    QCOMPARE(curve.points().size(), size_t{5});
    QCOMPARE(curve.plot().chosen(), 2);
    QTest::keyClick(&curve.plot(), Qt::Key_Delete);
    QCOMPARE(curve.points().size(), size_t{4});
}

void CurveEditorTest::takesNumbersBeyondWhite()
{
    Curve curve;
    curve.plot().choose(3);
    const QPointF white = curve.plot().placeOf(1.0, 1.0);
    curve.editor().after().setValue(1.5);
    QCOMPARE(curve.points()[3].y, 1.5);
    QVERIFY(curve.plot().placeOf(1.0, 1.0).y() > white.y() + 20.0); // the plot reaches farther
    curve.editor().before().setValue(0.1);
    QVERIFY(curve.points()[3].x > 0.75); // not past its neighbor, and shown as it is
    QVERIFY(std::abs(curve.editor().before().value() - curve.points()[3].x) < 1e-3);
}

void CurveEditorTest::putsAPointBackOnTheDiagonalByADoubleClick()
{
    Curve curve;
    QTest::mouseClick(&curve.plot(), Qt::LeftButton, {}, curve.at(0.25, 0.19));
    QTest::mouseDClick(&curve.plot(), Qt::LeftButton, {}, curve.at(0.25, 0.19));
    QTest::mouseRelease(&curve.plot(), Qt::LeftButton, {}, curve.at(0.25, 0.19));
    QCOMPARE(curve.points().size(), size_t{4});
    QCOMPARE(curve.points()[1].y, 0.25);
}

void CurveEditorTest::resetsToTheCurveThatChangesNothing()
{
    Curve curve;
    curve.editor().resetButton().click();
    QVERIFY(curve.points() == (std::vector<CurvePoint>{{0.0, 0.0}, {1.0, 1.0}}));
    for (int i = 0; i <= 100; ++i)
        QVERIFY(std::abs(CurveTable(curve.points()).at(0.01f * static_cast<float>(i)) - 0.01f * static_cast<float>(i)) < 1e-6f);
}

void CurveEditorTest::changesThePictureOneUndoStepADrag()
{
    Painting painting;
    painting.editor().addLayer({.name = "Curves", .content = CurvesLayer{}});
    auto* editor = painting.panel().layers().form().findChild<CurveEditor*>();
    QVERIFY(editor);
    CurvePlot& plot = editor->plot();
    QTRY_COMPARE(plot.height(), plot.sizeHint().height());
    painting.waitForPicture();
    const auto points = [&] { return std::get<CurvesLayer>(painting.editor().map()->layers[2].content).points; };
    const int before = painting.steps();
    Painting::drag(&plot, plot.placeOf(0.75, 0.81).toPoint(), plot.placeOf(0.6, 0.95).toPoint());
    QCOMPARE(painting.steps(), before + 1);
    QVERIFY(std::abs(points()[2].x - 0.6) < 0.01 && std::abs(points()[2].y - 0.95) < 0.01);
    Painting::drag(&plot, plot.placeOf(0.4, 0.1).toPoint(), plot.placeOf(0.45, 0.2).toPoint()); // a new point, at once dragged
    QCOMPARE(painting.steps(), before + 2);
    QCOMPARE(points().size(), size_t{5});
    painting.waitForPicture();
    QVERIFY(painting.editor().picture() == evaluate(*painting.editor().map(), {.size = painting.editor().size()}));
    painting.document().undoStack().undo();
    painting.document().undoStack().undo();
    QVERIFY(points() == CurvesLayer{}.points);
    QVERIFY(plot.points() == CurvesLayer{}.points);
}

void CurveEditorTest::explainsItsControls()
{
    Curve curve;
    QCOMPARE(unexplained(curve.editor()), QStringList());
    for (QWidget* widget :
         std::initializer_list<QWidget*>{&curve.plot(), &curve.editor().before(), &curve.editor().after(), &curve.editor().resetButton()})
        QVERIFY(!widget->toolTip().isEmpty());
    QVERIFY(curve.plot().toolTip().contains(QStringLiteral("square roots of linear light")));
}

} // namespace mirrorball::test
