#include "disc_handles_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "core/spheremap/math/light_place.h"

#include <QToolTip>

#include <cmath>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<DiscHandlesTest> registered;

namespace {

/// A map with one more layer, chosen.
class Handles : public Painting {
public:
    explicit Handles(const LayerContent& content)
    {
        editor().addLayer({.content = content});
        waitForPicture();
    }
    template <typename Kind>
    const Kind& layer()
    {
        return std::get<Kind>(editor().map()->layers[2].content);
    }
    DiscHandles& handles() { return canvas().handles(); }
    QPoint shown(int handle) { return handles().shownAt(handle).toPoint(); }
    /// Half a pixel's diagonal, in disc radii: places of the mouse are whole pixels.
    double pixel() { return 0.75 / (canvas().placeOf({1.0, 0.0}).x() - canvas().placeOf({0.0, 0.0}).x()); }
    bool isNear(const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < 2.0 * pixel(); }
    /// As a user does it: QTest's double click sends no release.
    void doubleClick(const QPoint& place)
    {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, place);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, place);
    }
    void moveTo(const QPoint& to, Qt::MouseButtons buttons = Qt::LeftButton)
    {
        QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, buttons, {});
        QCoreApplication::sendEvent(&canvas(), &move);
    }
};

} // namespace

void DiscHandlesTest::dragsALightLiveInOneUndoStep()
{
    Handles disc(PhongLightsLayer{});
    QCOMPARE(disc.handles().handles().size(), size_t{1});
    const int before = disc.steps();
    const PhongLight start = disc.layer<PhongLightsLayer>().lights[0];
    QTest::mousePress(&disc.canvas(), Qt::LeftButton, {}, disc.shown(0));
    disc.moveTo(disc.at(0.5, 0.0));
    QVERIFY(disc.layer<PhongLightsLayer>().lights[0].azimuthDeg != start.azimuthDeg); // at once
    disc.moveTo(disc.at(0.5, 0.1));
    disc.waitForPicture();
    // While it is dragged, of half as many texels; whole again afterwards.
    const int size = disc.editor().size();
    QVERIFY(disc.editor().picture() == evaluate(*disc.editor().map(), {.size = size / 2, .levelSize = size}));
    QTest::mouseRelease(&disc.canvas(), Qt::LeftButton, {}, disc.at(0.5, 0.1));
    disc.waitForPicture();
    QVERIFY(disc.editor().picture() == evaluate(*disc.editor().map(), {.size = size}));
    QCOMPARE(disc.steps(), before + 1);
    QVERIFY(disc.isNear(disc.handles().handles()[0].place, {0.5, 0.1}));
    disc.document().undoStack().undo();
    QCOMPARE(disc.layer<PhongLightsLayer>().lights[0].azimuthDeg, start.azimuthDeg);
    QVERIFY(disc.isNear(disc.handles().handles()[0].place, highlightPlace({start.azimuthDeg, start.polarDeg})));
}

void DiscHandlesTest::liesOnTheHighlightThatThePictureShows()
{
    Handles disc(PhongLightsLayer{.lights = {{.azimuthDeg = 20.0, .polarDeg = 130.0, .intensity = 500.0, .exponent = 300.0}}});
    const Image& picture = disc.editor().picture();
    int best = 0;
    for (int i = 0; i < picture.width * picture.height; ++i)
        if (picture.texels[4 * static_cast<size_t>(i)] > picture.texels[4 * static_cast<size_t>(best)])
            best = i;
    const double texel = 2.0 / picture.width;
    const glm::dvec2 peak((best % picture.width + 0.5) * texel - 1.0, 1.0 - (best / picture.width + 0.5) * texel);
    // Powers are exact to n 3e-6, by which the peak falls off within 0.0024 radians whatever the exponent n.
    QVERIFY(glm::distance(peak, disc.canvas().discAt(disc.handles().shownAt(0))) < 0.0024 + texel);
}

void DiscHandlesTest::keepsALightBehindInReach()
{
    Handles disc(GradientLayer{.azimuthDeg = 0.0, .polarDeg = 120.0}); // by n.l: past the rim
    QVERIFY(disc.isNear(disc.canvas().discAt(disc.handles().shownAt(0)), {1.0, 0.0}));
    disc.drag(disc.shown(0), disc.shown(0) + QPoint(-1, 0));
    QVERIFY(std::abs(disc.layer<GradientLayer>().polarDeg - 120.0) < 2.0); // no leap to the front
    disc.drag(disc.shown(0), disc.shown(0) + disc.at(0.0, 0.0) - disc.at(0.6, 0.0));
    QVERIFY(disc.layer<GradientLayer>().polarDeg < 90.0);
    disc.drag(disc.shown(0), disc.shown(0) + disc.at(0.9, 0.0) - disc.at(0.0, 0.0));
    QVERIFY(disc.layer<GradientLayer>().polarDeg > 90.0);
}

void DiscHandlesTest::movesTheLightOfAToonLayer()
{
    Handles disc(ToonLayer{});
    disc.drag(disc.shown(0), disc.at(-0.3, -0.4));
    const ToonLayer& toon = disc.layer<ToonLayer>();
    QVERIFY(disc.isNear(highlightPlace({toon.azimuthDeg, toon.polarDeg}), {-0.3, -0.4}));
}

void DiscHandlesTest::dragsGradientsWindowsAndTurns()
{
    Handles disc(GradientLayer{.shape = GradientShape::Linear});
    disc.drag(disc.shown(0), disc.at(-0.5, 0.0));
    disc.drag(disc.shown(1), disc.at(0.5, 0.0));
    const GradientLayer gradient = disc.layer<GradientLayer>();
    QVERIFY(disc.isNear({gradient.centerX, gradient.centerY}, {0.0, 0.0}));
    QVERIFY(std::abs(gradient.radius - 0.5) < 2.0 * disc.pixel());
    QVERIFY(std::abs(std::remainder(gradient.angleDeg, 360.0)) < 1.5);

    disc.editor().editLayer({}, {}, [](Layer& layer) { layer.content = WindowLayer{}; });
    disc.drag(disc.shown(0), disc.at(0.1, 0.2));
    QVERIFY(disc.isNear({disc.layer<WindowLayer>().centerX, disc.layer<WindowLayer>().centerY}, {0.1, 0.2}));
    const int corner = 1;
    disc.drag(disc.shown(corner), disc.shown(corner) + QPoint(12, 12));
    QVERIFY(disc.layer<WindowLayer>().width > WindowLayer{}.width && disc.layer<WindowLayer>().height > WindowLayer{}.height);
    disc.drag(disc.shown(2), disc.shown(2) + QPoint(-25, 0));
    QVERIFY(disc.layer<WindowLayer>().tiltDeg > WindowLayer{}.tiltDeg + 5.0); // counterclockwise

    disc.editor().editLayer({}, {}, [](Layer& layer) { layer.content = RotateLayer{}; });
    disc.drag(disc.shown(0), disc.at(0.5, 0.0));
    QVERIFY(std::abs(disc.layer<RotateLayer>().rightDeg - 30.0) < 1.0); // sin 30 degrees
}

void DiscHandlesTest::dragsTheMaskAsWell()
{
    Handles disc(PhongLightsLayer{});
    disc.editor().editLayer(
        {}, {}, [](Layer& layer) { layer.mask = Mask{.content = GradientLayer{.shape = GradientShape::Radial, .radius = 0.3}}; });
    QCOMPARE(disc.handles().handles().size(), size_t{3});
    QVERIFY(disc.handles().isOfMask(1) && !disc.handles().isOfMask(0));
    const int before = disc.steps();
    disc.drag(disc.shown(1), disc.at(0.5, -0.2));
    QCOMPARE(disc.steps(), before + 1);
    const auto& mask = std::get<GradientLayer>(disc.editor().map()->layers[2].mask->content);
    QVERIFY(disc.isNear({mask.centerX, mask.centerY}, {0.5, -0.2}));
    QVERIFY(disc.layer<PhongLightsLayer>() == PhongLightsLayer{});
    disc.doubleClick(disc.at(0.0, 0.6)); // a light of the layer, whatever of the mask was chosen
    QCOMPARE(disc.layer<PhongLightsLayer>().lights.size(), size_t{2});
    QCOMPARE(disc.handles().chosen(), 1);
    QVERIFY(disc.isNear(disc.handles().handles()[1].place, {0.0, 0.6}));
}

void DiscHandlesTest::movesByKeysOneStepAPress()
{
    Handles disc(PhongLightsLayer{.lights = {{.azimuthDeg = 0.0, .polarDeg = 60.0}, {.azimuthDeg = 180.0, .polarDeg = 60.0}}});
    const int before = disc.steps();
    QTest::keyClick(&disc.canvas(), Qt::Key_Up);
    QVERIFY(glm::distance(disc.handles().handles()[0].place, {0.5, 0.01}) < 1e-3);
    QTest::keyClick(&disc.canvas(), Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(glm::distance(disc.handles().handles()[0].place, {0.501, 0.01}) < 3e-4); // a hundredth of a degree
    QCOMPARE(disc.steps(), before + 2);
    QTest::keyClick(&disc.canvas(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(disc.handles().chosen(), 1);
    QTest::keyPress(&disc.canvas(), Qt::Key_Down); // held: it repeats, and is one step
    QTest::keyPress(&disc.canvas(), Qt::Key_Down);
    QTest::keyRelease(&disc.canvas(), Qt::Key_Down);
    QVERIFY(glm::distance(disc.handles().handles()[1].place, {-0.5, -0.02}) < 1e-3);
    QCOMPARE(disc.steps(), before + 3);
}

void DiscHandlesTest::addsAndRemovesLightsOnTheDisc()
{
    Handles disc(PhongLightsLayer{.lights = {{.exponent = 33.0}}});
    const int before = disc.steps();
    QTest::mouseClick(&disc.canvas(), Qt::LeftButton, {}, disc.at(0.3, -0.5));
    QCOMPARE(disc.steps(), before);
    disc.doubleClick(disc.at(0.3, -0.5));
    QCOMPARE(disc.steps(), before + 1);
    QCOMPARE(disc.layer<PhongLightsLayer>().lights.size(), size_t{2});
    QCOMPARE(disc.layer<PhongLightsLayer>().lights[1].exponent, 33.0);
    QVERIFY(disc.isNear(disc.handles().handles()[1].place, {0.3, -0.5}));
    QCOMPARE(disc.handles().chosen(), 1);
    QTest::keyClick(&disc.canvas(), Qt::Key_Delete);
    QCOMPARE(disc.layer<PhongLightsLayer>().lights.size(), size_t{1});
    QTest::keyClick(&disc.canvas(), Qt::Key_Delete);
    QVERIFY(disc.layer<PhongLightsLayer>().lights.empty());
    disc.doubleClick(disc.at(0.0, 0.0)); // none is left to be like
    QCOMPARE(disc.layer<PhongLightsLayer>().lights.size(), size_t{1});
    for (int i = 0; i < 4; ++i)
        disc.document().undoStack().undo();
    QCOMPARE(disc.layer<PhongLightsLayer>().lights.size(), size_t{1});
    QCOMPARE(disc.layer<PhongLightsLayer>().lights[0].azimuthDeg, PhongLight{}.azimuthDeg);
    QCOMPARE(disc.steps(), before);
}

void DiscHandlesTest::choosesTheSameLightAsTheForm()
{
    Handles disc(PhongLightsLayer{.lights = {{.azimuthDeg = 0.0}, {.azimuthDeg = 120.0}, {.azimuthDeg = 240.0}}});
    auto* chooser = disc.panel().layers().form().findChild<ItemChooser*>(QStringLiteral("lights"));
    auto* azimuth = disc.panel().layers().form().findChild<NumberField*>(QStringLiteral("azimuth"));
    QVERIFY(chooser && azimuth);
    QTest::mouseClick(&disc.canvas(), Qt::LeftButton, {}, disc.shown(2));
    QCOMPARE(chooser->chosen(), 2);
    QCOMPARE(azimuth->value(), 240.0);
    chooser->choose(1);
    QCOMPARE(disc.handles().chosen(), 1);
    chooser->removeButton().click();
    QCOMPARE(chooser->chosen(), disc.handles().chosen());
    chooser->addButton().click();
    QCOMPARE(chooser->chosen(), disc.handles().chosen());
    disc.document().undoStack().undo();
    QCOMPARE(chooser->chosen(), disc.handles().chosen());
    disc.editor().addLayer({.content = PhongLightsLayer{}}); // another list begins anew
    QCOMPARE(chooser->chosen(), 0);
    QCOMPARE(disc.handles().chosen(), 0);
}

void DiscHandlesTest::givesUpADragByEscape()
{
    Handles disc(PhongLightsLayer{});
    const int before = disc.steps();
    QTest::mousePress(&disc.canvas(), Qt::LeftButton, {}, disc.shown(0));
    disc.moveTo(disc.at(0.5, 0.0));
    QTest::keyClick(&disc.canvas(), Qt::Key_Escape);
    disc.moveTo(disc.at(0.6, 0.0));
    QTest::mouseRelease(&disc.canvas(), Qt::LeftButton, {}, disc.at(0.6, 0.0));
    QVERIFY(disc.layer<PhongLightsLayer>() == PhongLightsLayer{});
    QCOMPARE(disc.steps(), before);
}

void DiscHandlesTest::leavesThePaintLayersAlone()
{
    Handles disc(PhongLightsLayer{});
    disc.editor().choose(1);
    QVERIFY(!disc.handles().isActive());
    disc.drag(disc.at(-0.3, 0.0), disc.at(0.3, 0.0));
    QCOMPARE(disc.strokes().size(), size_t{1});
    // A painted mask takes the strokes of its layer.
    disc.editor().choose(2);
    QVERIFY(disc.handles().isActive());
    disc.editor().editLayer({}, {}, [](Layer& layer) { layer.mask = Mask{.content = PaintLayer{}}; });
    disc.editor().setPaintsMask(true);
    QVERIFY(!disc.handles().isActive());
    // What is hidden is not dragged.
    disc.editor().editLayer({}, {}, [](Layer& layer) { layer.mask.reset(), layer.visible = false; });
    QVERIFY(!disc.handles().isActive());
}

void DiscHandlesTest::leavesPickingPanningAndBrushKeysAsTheyAre()
{
    Handles disc(PhongLightsLayer{.lights = {{.color = {0.0, 0.5, 1.0}, .intensity = 1.0}}});
    const int before = disc.steps();
    QTest::mouseClick(&disc.canvas(), Qt::LeftButton, Qt::AltModifier, disc.shown(0));
    QCOMPARE(disc.steps(), before);
    QVERIFY(disc.editor().brush().color != Brush{}.color);
    disc.editor().setTool(PaintTool::PickColor);
    QVERIFY(!disc.handles().isActive());
    disc.editor().setTool(PaintTool::Paint);
    const QPoint center = disc.at(0.0, 0.0);
    QTest::keyPress(&disc.canvas(), Qt::Key_Space);
    disc.drag(disc.shown(0), disc.shown(0) + QPoint(20, 0));
    QTest::keyRelease(&disc.canvas(), Qt::Key_Space);
    QCOMPARE(disc.at(0.0, 0.0), center + QPoint(20, 0));
    QTest::keyClick(&disc.canvas(), Qt::Key_Home);
    QCOMPARE(disc.at(0.0, 0.0), center);
    const double radius = disc.editor().brush().radius;
    QTest::keyClick(&disc.canvas(), Qt::Key_BracketRight);
    QVERIFY(disc.editor().brush().radius > radius);
    QCOMPARE(disc.steps(), before);
}

void DiscHandlesTest::saysTheAnglesOfWhatIsPointedAt()
{
    Handles disc(PhongLightsLayer{.lights = {{.azimuthDeg = 30.0, .polarDeg = 60.0}}});
    QCOMPARE(disc.canvas().cursor().shape(), Qt::ArrowCursor);
    disc.moveTo(disc.shown(0), Qt::NoButton);
    QCOMPARE(disc.canvas().cursor().shape(), Qt::OpenHandCursor);
    QCOMPARE(disc.handles().describe(0), QStringLiteral("Light 1: azimuth 30.0°, polar 60.0°"));
    QCOMPARE(disc.canvas().accessibleDescription(), disc.handles().describe(0));
    QHelpEvent help(QEvent::ToolTip, disc.shown(0), disc.canvas().mapToGlobal(disc.shown(0)));
    QCoreApplication::sendEvent(&disc.canvas(), &help);
    QCOMPARE(QToolTip::text(), disc.handles().describe(0));
}

/// For people to look at: MIRRORBALL_SCREENSHOTS.
void DiscHandlesTest::looksWell()
{
    Handles disc(
        PhongLightsLayer{.lights = {{.color = {1.0, 0.7, 0.4}}, {.azimuthDeg = -40.0, .polarDeg = 120.0, .color = {0.3, 0.5, 1.0}}}});
    disc.canvas().setFocus();
    const auto keep = [&](const char* name) {
        disc.waitForPicture();
        QTest::qWait(80);
        keepScreenshot(disc.panel(), QStringLiteral("handles-%1").arg(QLatin1String(name)));
    };
    keep("phong");
    for (const LayerKind& kind : layerKinds()) {
        if (kind.name == "image" || discHandles(makeContent(kind.name)).empty())
            continue;
        disc.editor().addLayer({.content = makeContent(kind.name)});
        keep(std::string(kind.name).c_str());
        disc.editor().removeChosen();
    }
    for (const GradientShape shape : {GradientShape::Radial, GradientShape::Linear, GradientShape::Angular}) {
        disc.editor().addLayer({.content = GradientLayer{.shape = shape, .radius = 0.6}});
        keep(std::string("gradient-").append(wordOf(shape)).c_str());
        disc.editor().removeChosen();
    }
    disc.editor().addLayer({.content = GradientLayer{.polarDeg = 130.0}});
    keep("behind");
    disc.editor().addLayer({.content = CurvesLayer{}});
    keep("curves");
}

} // namespace mirrorball::test
