#include "painted_level_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "core/image/color.h"
#include "support/picture_builders.h"

#include <QPushButton>
#include <QSignalSpy>

#include <cmath>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PaintedLevelTest> registered;

namespace {

/// A map that is red in level 3 and green in all others.
SphereMapDocument redInLevelThree()
{
    SphereMapDocument map;
    map.layers = {{.name = "Ground", .content = FillLayer{.color = {0.0, 0.6, 0.0}}},
                  {.name = "Third", .content = FillLayer{.color = {0.6, 0.0, 0.0}}, .firstLevel = 3, .lastLevel = 3}};
    return map;
}

/// A dock with its levels in front.
class Levels : public Painting {
public:
    Levels()
    {
        panel().tabs().setCurrentIndex(2);
        waitForLevels();
    }
    LevelsView& view() { return panel().levels(); }
    void waitForLevels() { QTRY_VERIFY_WITH_TIMEOUT(!view().levels().isEmpty(), 20000); }
    void click(int level) { QTest::mouseClick(&view(), Qt::LeftButton, {}, view().cell(level).center().toPoint()); }
    /// What disc and model show in their middle.
    QColor ofDisc()
    {
        waitForPicture();
        return canvas().grab().toImage().pixelColor(canvas().placeOf({0.3, 0.3}).toPoint() * canvas().devicePixelRatioF());
    }
    QColor ofModel()
    {
        const QImage picture = window().picture();
        return picture.pixelColor(picture.width() / 2, picture.height() / 2);
    }
    QPushButton& badge() { return *window().preview().findChild<QPushButton*>(QStringLiteral("levelBadge")); }
};

bool isRed(const QColor& color) { return color.red() > 150 && color.green() < 60; }
bool isGreen(const QColor& color) { return color.green() > 150 && color.red() < 60; }

} // namespace

void PaintedLevelTest::aClickShowsOneLevelOnDiscAndModel()
{
    Levels levels;
    levels.editor().setMap(QStringLiteral("levels"), redInLevelThree());
    QVERIFY(isGreen(levels.ofModel()) && isGreen(levels.ofDisc()));
    QVERIFY(!levels.badge().isVisible());
    levels.click(3);
    QCOMPARE(levels.editor().onlyLevel(), std::optional(3));
    QTRY_VERIFY_WITH_TIMEOUT(isRed(levels.ofDisc()), 10000);
    QVERIFY2(isRed(levels.ofModel()), qPrintable(levels.ofModel().name()));
    QVERIFY(levels.badge().isVisible());
    QVERIFY2(levels.badge().text().contains(QStringLiteral("Level 3 only")), qPrintable(levels.badge().text()));
    keepScreenshot(*levels.window(), QStringLiteral("level-alone"));
    keepScreenshot(levels.panel(), QStringLiteral("level-alone-dock"));
    levels.click(2);
    QVERIFY(isGreen(levels.ofModel()));
    levels.click(2); // the one that is shown: all again
    QCOMPARE(levels.editor().onlyLevel(), std::optional<int>());
    QVERIFY(isGreen(levels.ofDisc()) && isGreen(levels.ofModel()));
    QVERIFY(!levels.badge().isVisible());
}

void PaintedLevelTest::strokesGoToThatLevelAlone()
{
    Levels levels; // ground and paint
    const SphereMapDocument before = *levels.editor().map();
    levels.click(2);
    levels.waitForPicture();
    levels.drag(levels.at(-0.3, 0.0), levels.at(0.3, 0.0));
    const SphereMapDocument& after = *levels.editor().map();
    QCOMPARE(after.layers.size(), before.layers.size() + 1);
    QCOMPARE(after.layers.back().firstLevel, 2);
    QCOMPARE(after.layers.back().lastLevel, 2);
    QCOMPARE(std::get<PaintLayer>(after.layers.back().content).strokes.size(), size_t{1});
    const std::vector<Image> were = evaluateLevels(before, 256), are = evaluateLevels(after, 256);
    for (size_t i = 0; i < are.size(); ++i) {
        double most = 0.0; // levels of their own are made finer and averaged: not the same bytes as averages
        for (size_t t = 0; t < are[i].texels.size(); ++t)
            most = std::max(most, std::abs(double(are[i].texels[t]) - double(were[i].texels[t])));
        QVERIFY2((most > 0.1) == (i == 2), qPrintable(QString::number(i)));
    }
    levels.drag(levels.at(0.0, -0.3), levels.at(0.0, 0.3)); // into the same layer
    QCOMPARE(levels.editor().map()->layers.size(), before.layers.size() + 1);
    QCOMPARE(std::get<PaintLayer>(levels.editor().map()->layers.back().content).strokes.size(), size_t{2});
    levels.document().undoStack().undo();
    levels.document().undoStack().undo();
    levels.document().undoStack().undo();
    QVERIFY(*levels.editor().map() == before);
}

void PaintedLevelTest::aStrokeOnTheModelIsSeenWhileItIsDrawn()
{
    Levels levels;
    levels.document().edit(QStringLiteral("ball"), {}, [](Scene& scene) { scene.view.geometry = "sphere"; });
    levels.click(2);
    levels.editor().setPaintsOnModel(true);
    Brush brush = levels.editor().brush();
    brush.color = {1.0, 0.0, 0.0};
    brush.radius = 0.2;
    brush.flow = brush.hardness = 1.0; // one dab covers
    levels.editor().setBrush(brush);
    PreviewWidget& preview = levels.window().preview();
    const QPoint middle = preview.rect().center();
    QVERIFY(!isRed(levels.ofModel()));
    QTest::mousePress(&preview, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(12, 0), preview.mapToGlobal(QPointF(middle + QPoint(12, 0))), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&preview, &move);
    QTRY_VERIFY_WITH_TIMEOUT(isRed(levels.ofModel()), 15000); // the pen is still down
    QVERIFY(levels.editor().isPainting());
    QTest::mouseRelease(&preview, Qt::LeftButton, {}, middle + QPoint(12, 0));
    QVERIFY(isRed(levels.ofModel()));
    levels.editor().showOnly(0); // painted in its own level alone
    QVERIFY(!isRed(levels.ofModel()));
}

void PaintedLevelTest::escapeShowsAllLevelsAgain_data()
{
    QTest::addColumn<QString>("where");
    for (const char* where : {"levels", "disc", "picture", "badge"})
        QTest::newRow(where) << QString::fromLatin1(where);
}

void PaintedLevelTest::escapeShowsAllLevelsAgain()
{
    QFETCH(QString, where);
    Levels levels;
    levels.click(4);
    QVERIFY(levels.editor().onlyLevel());
    if (where == QStringLiteral("levels"))
        QTest::keyClick(&levels.view(), Qt::Key_Escape);
    else if (where == QStringLiteral("disc"))
        QTest::keyClick(&levels.canvas(), Qt::Key_Escape);
    else if (where == QStringLiteral("picture"))
        QTest::keyClick(&levels.window().preview(), Qt::Key_Escape);
    else
        QTest::mouseClick(&levels.badge(), Qt::LeftButton);
    QVERIFY(!levels.editor().onlyLevel());
}

void PaintedLevelTest::keysGoFromLevelToLevel()
{
    Levels levels;
    QTest::keyClick(&levels.view(), Qt::Key_Right);
    QCOMPARE(levels.editor().onlyLevel(), std::optional(0));
    QTest::keyClick(&levels.view(), Qt::Key_Right);
    QCOMPARE(levels.editor().onlyLevel(), std::optional(1));
    QTest::keyClick(&levels.view(), Qt::Key_Left);
    QTest::keyClick(&levels.view(), Qt::Key_Left);
    QCOMPARE(levels.editor().onlyLevel(), std::optional(0));
}

// Every second texel is white: the eye far away sees half the light everywhere, 188 of 255, and so does a small picture of it that
// averages.
void PaintedLevelTest::thumbnailsAreAverages()
{
    const TemporaryFolder folder;
    Image checkers(1024, 1024, 3);
    for (int y = 0; y < 1024; ++y)
        for (int x = 0; x < 1024; ++x)
            std::fill_n(checkers.texel(x, y), 3, (x + y) % 2 == 0 ? 1.0f : 0.0f);
    writePng(folder / "checkers.png", checkers, 8);
    Levels levels;
    SphereMapDocument map;
    map.layers = {{.content = ImageLayer{.source = (folder / "checkers.png").string(), .inset = 0.0}}};
    levels.editor().setMap(QStringLiteral("checkers"), map);
    QSignalSpy updated(&levels.view(), &LevelsView::updated);
    QTRY_VERIFY_WITH_TIMEOUT(!updated.isEmpty(), 20000);
    QCOMPARE(levels.document().scene().material.sphereMap.size, 1024);
    const QImage picture = levels.view().grab().toImage();
    const QRect cell = levels.view().cell(0).toRect();
    const QRect inside = cell.adjusted(cell.width() / 4, cell.height() / 4, -cell.width() / 4, -cell.height() / 4); // of the disc
    for (int y = inside.top(); y < inside.bottom(); ++y)
        for (int x = inside.left(); x < inside.right(); ++x)
            QVERIFY2(std::abs(picture.pixelColor(x, y).green() - 188) <= 8, qPrintable(picture.pixelColor(x, y).name()));
}

} // namespace mirrorball::test
