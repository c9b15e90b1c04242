#include "inspector_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/image_io.h"
#include "core/preview/picture_file.h"
#include "core/sphere/direction.h"

#include <QRegularExpression>

#include <cmath>
#include <numeric>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<InspectorTest> registered;

void InspectorTest::init() { QSettings().clear(); }

namespace {

void press(StudioWindow& window, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), key, modifiers);
}

PictureInspector& inspector(StudioWindow& window) { return window.preview().inspector(); }

QString text(StudioWindow& window, const char* row) { return inspector(window).text(QLatin1String(row)); }

/// Points at a place until its values are told.
void pointAt(StudioWindow& window, const QPoint& place)
{
    window.waitForPicture();
    QTest::mouseMove(&window.preview(), place + QPoint(2, 2));
    QTest::mouseMove(&window.preview(), place);
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "pixel"), QStringLiteral("%1, %2").arg(place.x()).arg(place.y()), patience);
    QTRY_VERIFY_WITH_TIMEOUT(text(window, "linear") != QStringLiteral("–"), patience);
}

/// The numbers of a row.
QVector<double> numbers(const QString& text)
{
    QVector<double> found;
    for (const QString& word : text.split(QRegularExpression(QStringLiteral("[ (),°]+")), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const double number = word.toDouble(&isNumber);
        if (isNumber)
            found << number;
    }
    return found;
}

glm::dvec3 vectorOf(const QString& text)
{
    const QVector<double> n = numbers(text);
    return n.size() < 3 ? glm::dvec3(HUGE_VAL) : glm::dvec3(n[0], n[1], n[2]);
}

/// The radiance that `mirrorball render -o x.exr` writes.
Image light(StudioWindow& window, const QSize& size)
{
    Scene scene = window.document().scene();
    scene.view.width = size.width();
    scene.view.height = size.height();
    return preview::drawPicture(planScene(scene), preview::PictureLight::Radiance).image;
}

bool isClose(const glm::dvec3& a, const glm::dvec3& b, double relative)
{
    return glm::distance(a, b) <= relative * std::max(glm::length(b), 1e-3);
}

void showFlat(StudioWindow& window, double value)
{
    window.document().edit(QStringLiteral("flat"), {},
                           [value](Scene& scene) { scene.view.background = {.kind = Backdrop::Color, .color = glm::dvec3(value)}; });
}

} // namespace

void InspectorTest::theValuesAreThoseOfTheFiles()
{
    StudioWindow window;
    window.document().edit(QStringLiteral("exposed"), {}, [](Scene& scene) { scene.view.exposure = 1.0; }); // the light is not
    window.show();
    QVERIFY(!inspector(window).isVisible());
    press(window, Qt::Key_I);
    QVERIFY(inspector(window).isVisible());
    const QImage shown = window.picture();
    const Image radiance = light(window, shown.size());
    for (const QPoint& place : {QPoint(shown.width() / 2, shown.height() / 2), QPoint(shown.width() / 2 - 40, shown.height() / 2 + 25),
                                QPoint(30, shown.height() - 40)}) {
        pointAt(window, place);
        const float* t = radiance.texel(place.x(), place.y());
        QVERIFY2(isClose(vectorOf(text(window, "linear")), {t[0], t[1], t[2]}, 2e-3), qPrintable(text(window, "linear"))); // four digits
        const QColor color = shown.pixelColor(place);
        QCOMPARE(text(window, "display"),
                 QStringLiteral("%1  %2  %3  %4").arg(color.red()).arg(color.green()).arg(color.blue()).arg(color.name()));
    }
    pointAt(window, {shown.width() / 2, shown.height() / 2});
    QTRY_VERIFY_WITH_TIMEOUT(window->workspace().cursor.direction(), patience);
    QVERIFY(glm::distance(vectorOf(text(window, "direction")), *window->workspace().cursor.direction()) < 0.02); // two digits
    keepScreenshot(*window, QStringLiteral("inspect-values"));

    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&window.preview(), &leave);
    QCOMPARE(text(window, "linear"), QStringLiteral("–"));
}

// Of a probe whose radiance says where it comes from, the light that is told is the direction that is told.
void InspectorTest::besideTheModelTheDirectionIsTheBackgrounds()
{
    const TemporaryFolder folder;
    EnvironmentMap probe({Parameterization::Latlong, 128, 0});
    for (int y = 0; y < probe.image.height; ++y)
        for (int x = 0; x < probe.image.width; ++x)
            for (int c = 0; c < 3; ++c)
                probe.image.texel(x, y)[c] = static_cast<float>(0.5 + 0.5 * texelDirection(probe.layout, x, y)[c]);
    writeImage(folder / "where.exr", probe.image);
    StudioWindow window;
    window.document().edit(QStringLiteral("where"), {}, [&](Scene& scene) {
        scene.probe.source = (folder / "where.exr").string();
        scene.probe.yawDeg = 30.0;
        scene.view.geometry = "sphere";
        scene.view.camera.distance = 8.0;
        scene.view.camera.pitchDeg = 20.0;
        scene.view.camera.yawDeg = 50.0;
    });
    window.show();
    press(window, Qt::Key_I);
    const int right = window.preview().width() - 1;
    for (const QPoint& place : {QPoint(10, 10), QPoint(right - 10, 12), QPoint(12, window.preview().height() / 2)}) {
        pointAt(window, place);
        QCOMPARE(text(window, "level"), QStringLiteral("–"));
        const QVector<double> told = numbers(text(window, "direction"));
        QCOMPARE(told.size(), 5);
        const glm::dvec3 direction = directionFromLonLat(told[3] * pi / 180.0, told[4] * pi / 180.0); // to a tenth of a degree
        QVERIFY(glm::distance(direction, {told[0], told[1], told[2]}) < 0.02);                        // two digits
        QVERIFY2(glm::distance(2.0 * vectorOf(text(window, "linear")) - 1.0, direction) < 0.01, qPrintable(text(window, "linear")));
    }
}

// lambda is the least level that is read; beyond what the footprint asks for it is the level.
void InspectorTest::theLevelIsWhatTheLookupReads()
{
    StudioWindow window;
    window.document().edit(QStringLiteral("blurred"), {}, [](Scene& scene) {
        scene.view.geometry = "sphere";
        scene.material.lambda = 4.0;
    });
    window.show();
    press(window, Qt::Key_I);
    pointAt(window, window.preview().rect().center());
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "level"), QStringLiteral("4.00"), patience);
    window.document().edit(QStringLiteral("sharp"), {}, [](Scene& scene) { scene.material.lambda = 0.0; });
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "level"), QStringLiteral("–"), patience); // a mirror's map has no levels
}

void InspectorTest::valuesFollowAnEdit()
{
    StudioWindow window;
    showFlat(window, 0.25);
    window.show();
    press(window, Qt::Key_I);
    pointAt(window, {20, 20});
    QCOMPARE(text(window, "linear"), QStringLiteral("0.25  0.25  0.25"));
    QCOMPARE(text(window, "direction"), QStringLiteral("–")); // one color comes from nowhere
    showFlat(window, 3.0);
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "linear"), QStringLiteral("3  3  3"), patience); // the mouse has not moved
}

void InspectorTest::whereASnapshotIsShownItsLightIsTold()
{
    StudioWindow window;
    showFlat(window, 0.25);
    window.show();
    press(window, Qt::Key_K, Qt::ControlModifier);
    showFlat(window, 0.75);
    press(window, Qt::Key_S);
    press(window, Qt::Key_I);
    const int right = window.preview().width() - 20, high = window.preview().height() - 20; // beside both models
    pointAt(window, {20, high});
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "linear"), QStringLiteral("0.25  0.25  0.25"), patience);
    pointAt(window, {right, high});
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "linear"), QStringLiteral("0.75  0.75  0.75"), patience);
    press(window, Qt::Key_W);
    pointAt(window, {20, high});
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "linear"), QStringLiteral("0.25  0.25  0.25"), patience);
    pointAt(window, {right, high});
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "linear"), QStringLiteral("0.75  0.75  0.75"), patience);
}

void InspectorTest::clippedPixelsAreMarked()
{
    StudioWindow window;
    showFlat(window, 0.75);
    window.document().edit(QStringLiteral("dark"), {}, [](Scene& scene) { scene.material.specular.weight = 0.0; });
    window.show();
    press(window, Qt::Key_C);
    QTRY_COMPARE_WITH_TIMEOUT(text(window, "clipping"), QStringLiteral("0.0 % above 1, 0.0 % below 0"), patience);
    const auto isMarked = [&](QRgb mark) {
        int count = 0;
        const QImage& marks = inspector(window).marks();
        for (int x = 0; x < std::min(64, marks.width()); ++x)
            count += marks.pixel(x, 5) == mark;
        return count;
    };
    QCOMPARE(isMarked(qRgb(255, 40, 40)), 0);
    press(window, Qt::Key_E); // 0.75 * sqrt(2) is above 1
    QTRY_VERIFY_WITH_TIMEOUT(!window.document().isDragging(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(isMarked(qRgb(255, 40, 40)) > 0, patience);
    QVERIFY(std::abs(isMarked(qRgb(255, 40, 40)) - 32) <= 4); // stripes: every second one is the picture's
    QVERIFY(inspector(window).isVisible());
    const double share = numbers(text(window, "clipping")).value(0);
    QVERIFY2(share > 40.0 && share < 100.0, qPrintable(text(window, "clipping"))); // all but the dark model
    keepScreenshot(*window, QStringLiteral("inspect-clipping"));
    const QImage seen = window.preview().grab().toImage();
    int red = 0;
    for (int x = 0; x < 64; ++x)
        red += seen.pixelColor(x, 5) == QColor(255, 40, 40);
    QVERIFY(red > 20); // they are on the screen

    window.document().edit(QStringLiteral("orbit"), QStringLiteral("orbit"), [](Scene& scene) { scene.view.camera.yawDeg += 10; });
    QTRY_VERIFY_WITH_TIMEOUT(inspector(window).marks().isNull(), patience); // marks of another picture mark nothing
    window.document().finishEdit();
    QTRY_VERIFY_WITH_TIMEOUT(!inspector(window).marks().isNull(), patience);
    press(window, Qt::Key_C);
    QVERIFY(inspector(window).marks().isNull());
}

void InspectorTest::theHistogramCountsThePicture()
{
    StudioWindow window;
    showFlat(window, 0.5);
    window.document().edit(QStringLiteral("plain"), {}, [](Scene& scene) { scene.view.tone = ToneChoice::None; });
    window.show();
    press(window, Qt::Key_H);
    const QImage shown = window.picture();
    auto& view = *window.preview().findChild<HistogramView*>();
    const quint32 pixels = static_cast<quint32>(shown.width()) * static_cast<quint32>(shown.height());
    const auto total = [&](size_t channel) {
        return std::accumulate(view.histogram()[channel].begin(), view.histogram()[channel].end(), quint32(0));
    };
    for (size_t channel = 0; channel < 3; ++channel)
        QTRY_COMPARE_WITH_TIMEOUT(total(channel), pixels, patience);
    QVERIFY(view.histogram()[0][188] > pixels / 3); // 255 encodeSrgb(0.5) = 187.5
    keepScreenshot(*window, QStringLiteral("inspect-histogram"));
}

void InspectorTest::keysSwitchAndTheNextRunKnows()
{
    {
        StudioWindow window;
        window.show();
        for (const Qt::Key key : {Qt::Key_I, Qt::Key_H})
            press(window, key);
        QVERIFY(inspector(window).inspections() == (Inspect::Values | Inspect::Histogram));
        QCOMPARE(window.document().undoStack().count(), 0);
    }
    StudioWindow again;
    again.show();
    QVERIFY(inspector(again).inspections() == (Inspect::Values | Inspect::Histogram));
    QVERIFY(again->findChild<QAction*>(QStringLiteral("inspect.values"))->isChecked());
    press(again, Qt::Key_I);
    press(again, Qt::Key_H);
    QVERIFY(!inspector(again).isVisible());
}

} // namespace mirrorball::test
