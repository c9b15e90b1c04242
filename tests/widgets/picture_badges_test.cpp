#include "picture_badges_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/color.h"
#include "core/image/image_io.h"

#include <QPushButton>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PictureBadgesTest> registered;

static const QColor orange(237, 153, 97);

static bool isNear(const QColor& a, const QColor& b, int steps)
{
    return std::abs(a.red() - b.red()) <= steps && std::abs(a.green() - b.green()) <= steps && std::abs(a.blue() - b.blue()) <= steps;
}

static void paintAllOrange(StudioWindow& window)
{
    SphereMapDocument map;
    const auto linear = [](int byte) { return static_cast<double>(decodeSrgb(static_cast<float>(byte) / 255.0f)); };
    map.layers = {{.name = "Ground", .content = FillLayer{.color = {linear(orange.red()), linear(orange.green()), linear(orange.blue())}}}};
    window->workspace().sphereMap.setMap(QStringLiteral("paint"), map);
}

void PictureBadgesTest::paintIsShownInItsOwnColorsAndAClickSwitchesTheCurve()
{
    StudioWindow window;
    window.show();
    auto* badge = window.preview().findChild<QPushButton*>(QStringLiteral("paintBadge"));
    QVERIFY(badge && !badge->isVisible()); // light, not paint
    paintAllOrange(window);
    const auto middle = [&] {
        const QImage picture = window.picture();
        return picture.pixelColor(picture.width() / 2, picture.height() / 2);
    };
    QVERIFY2(isNear(middle(), orange, 1), qPrintable(middle().name()));
    QVERIFY(badge->isVisible());
    QCOMPARE(badge->text(), QStringLiteral("Colors as painted"));
    QVERIFY(window.preview().rect().contains(QRect(badge->mapTo(&window.preview(), QPoint()), badge->size())));
    keepScreenshot(*window, QStringLiteral("colors-as-painted"));

    QTest::mouseClick(badge, Qt::LeftButton);
    QCOMPARE(window.document().scene().view.tone, ToneChoice::Filmic);
    QVERIFY2(!isNear(middle(), orange, 5), qPrintable(middle().name()));
    QVERIFY(badge->isVisible());
    QVERIFY(badge->text() != QStringLiteral("Colors as painted"));

    QTest::mouseClick(badge, Qt::LeftButton);
    QCOMPARE(window.document().scene().view.tone, ToneChoice::Auto);
    QVERIFY(isNear(middle(), orange, 1));
    window.document().edit(QStringLiteral("over"), {}, [](Scene& scene) { scene.material.sphereMap.use = SphereMapUse::Over; });
    QVERIFY(!badge->isVisible());
}

void PictureBadgesTest::aProbeThatVanishesStaysInThePictureUnderItsName()
{
    const TemporaryFolder folder;
    const std::filesystem::path probe = folder / "room.hdr", away = folder / "away.hdr";
    writeImage(probe, renderBuiltinProbe("cube-room", {Parameterization::Latlong, 128, 0}).image);
    StudioWindow window;
    window.show();
    QVERIFY(dropFiles(*window, {QString::fromStdString(probe.string())}));
    const QImage good = window.picture();
    const MapLevels maps = window->workspace().live.made()->maps.specular;
    auto* badge = window.preview().findChild<QPushButton*>(QStringLiteral("keptBadge"));
    QVERIFY(badge && !badge->isVisible());

    std::filesystem::rename(probe, away);
    QTRY_VERIFY_WITH_TIMEOUT(badge->isVisible(), 10000);
    QVERIFY2(badge->text().contains(QStringLiteral("room.hdr")), qPrintable(badge->text()));
    QVERIFY2(badge->toolTip().contains(QStringLiteral("room.hdr")), qPrintable(badge->toolTip()));
    const QImage kept = window.picture(); // a little lower: the problem is named above it
    QVERIFY(window->workspace().live.made()->maps.specular == maps);
    keepScreenshot(*window, QStringLiteral("probe-as-last-read"));
    window.document().edit(QStringLiteral("glossy"), {}, [](Scene& scene) { scene.material.specular.lobe = SurfaceLobe::Phong; });
    QVERIFY(largestDifference(window.picture(), kept) > 20); // work goes on
    window.document().undoStack().undo();

    std::filesystem::rename(away, probe);
    QTest::mouseClick(badge, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!badge->isVisible(), 10000);
    QTRY_COMPARE_WITH_TIMEOUT(largestDifference(window.picture(), good), 0, 10000);
}

} // namespace mirrorball::test
