#include "comparison_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/color.h"
#include "core/image/image_io.h"
#include "core/preview/picture_file.h"
#include "widgets/controls/text.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include <cmath>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ComparisonTest> registered;

void ComparisonTest::init() { QSettings().clear(); }

namespace {

void makeGold(StudioWindow& window)
{
    window.document().edit(QStringLiteral("gold"), {}, [](Scene& scene) { scene.material.fresnel = {.kind = FresnelKind::Conductor}; });
}

void press(StudioWindow& window, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), key, modifiers);
}

Snapshots& snapshots(StudioWindow& window) { return window->workspace().snapshots; }

QListWidget& list(StudioWindow& window)
{
    QDockWidget* dock = window->dock(QStringLiteral("snapshots"));
    dock->show();
    dock->raise();
    return *dock->findChild<QListWidget*>(QStringLiteral("snapshots.list"));
}

QLabel& label(StudioWindow& window, const char* name) { return *window.preview().findChild<QLabel*>(QLatin1String(name)); }

/// What `mirrorball render` draws of the document's scene at a size.
QImage drawn(StudioWindow& window, const QSize& size)
{
    Scene scene = window.document().scene();
    scene.view.width = size.width();
    scene.view.height = size.height();
    const Image picture = preview::drawPicture(planScene(scene), preview::PictureLight::Display).image;
    QImage image(size, QImage::Format_RGB888);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const float* t = picture.texel(x, y);
            image.setPixel(x, y, qRgb(toByte(t[0]), toByte(t[1]), toByte(t[2])));
        }
    return image;
}

Image values(const QImage& picture)
{
    Image image(picture.width(), picture.height(), 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const QColor color = picture.pixelColor(x, y);
            const int rgb[] = {color.red(), color.green(), color.blue()};
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(rgb[c]) / 255.0f;
        }
    return image;
}

/// Pictures that differ in last bits have figures that differ in the third digit at most.
bool areAlike(const PictureError& a, const PictureError& b)
{
    return std::abs(a.relRms - b.relRms) < 2e-3 * b.relRms && std::abs(a.psnr - b.psnr) < 0.02 && std::abs(a.ssim - b.ssim) < 2e-3;
}

bool waitForFigures(StudioWindow& window)
{
    window.waitForPicture();
    return QTest::qWaitFor([&] { return snapshots(window).error().has_value(); }, patience);
}

struct Halves {
    QImage kept, now;
};
Halves halves(const QImage& picture)
{
    const int half = picture.width() / 2;
    return {picture.copy(0, 0, half, picture.height()), picture.copy(picture.width() - half, 0, half, picture.height())};
}

} // namespace

void ComparisonTest::snapshotsHaveNamesAndPictures()
{
    StudioWindow window;
    window.show();
    QListWidget& shown = list(window);
    QVERIFY(!window->findChild<QComboBox*>(QStringLiteral("snapshots.compare"))->isEnabled());
    press(window, Qt::Key_K, Qt::ControlModifier);
    makeGold(window);
    window.waitForPicture();
    press(window, Qt::Key_K, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 2, patience);
    QCOMPARE(shown.item(0)->text(), QStringLiteral("Snapshot 1"));
    QCOMPARE(shown.currentRow(), 1); // the newest is A
    const auto& all = snapshots(window).all();
    QCOMPARE(all[0].thumbnail.size(), Snapshots::thumbnailSize);
    QVERIFY(largestDifference(all[0].thumbnail, all[1].thumbnail) > 20);
    QVERIFY(!shown.item(0)->icon().isNull());

    // While a comparison shows something else, a snapshot's picture is still of what is shown now.
    // The figures are there by then, so that nothing is left to be drawn for them.
    press(window, Qt::Key_D);
    QVERIFY(waitForFigures(window));
    press(window, Qt::Key_K, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(all.size() == 3 && !all[2].thumbnail.isNull(), patience);
    QVERIFY(largestDifference(all[2].thumbnail, all[1].thumbnail) <= 8); // smoothed the same
    keepScreenshot(*window, QStringLiteral("snapshots"));

    QTest::mouseClick(shown.viewport(), Qt::LeftButton, {}, shown.visualItemRect(shown.item(0)).center());
    QCOMPARE(snapshots(window).chosen(), 0);
    QCOMPARE(window.document().undoStack().count(), 1); // none of this is an edit
}

void ComparisonTest::aSnapshotIsRenamedAndDeletedByKeys()
{
    StudioWindow window;
    window.show();
    QListWidget& shown = list(window);
    for (int i = 0; i < 3; ++i)
        press(window, Qt::Key_K, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 3, patience);
    shown.setFocus();
    shown.setCurrentRow(1);
    QTest::keyClick(&shown, Qt::Key_F2);
    QWidget* editor = shown.viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("brushed"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(shown.item(1)->text(), QStringLiteral("brushed"), patience);
    QCOMPARE(snapshots(window).compared()->name, QStringLiteral("brushed"));

    snapshots(window).setComparison(Comparison::Wipe);
    shown.setFocus();
    QTest::keyClick(&shown, Qt::Key_Delete);
    QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 2, patience);
    QCOMPARE(snapshots(window).compared()->name, QStringLiteral("Snapshot 3")); // the next one is A
    QTest::keyClick(&shown, Qt::Key_Delete);
    QCOMPARE(snapshots(window).compared()->name, QStringLiteral("Snapshot 1"));
    QCOMPARE(snapshots(window).comparison(), Comparison::Wipe);
    QTest::keyClick(&shown, Qt::Key_Delete);
    QVERIFY(!snapshots(window).compared());
    QCOMPARE(snapshots(window).comparison(), Comparison::Off);
    press(window, Qt::Key_K, Qt::ControlModifier);
    QCOMPARE(snapshots(window).compared()->name, QStringLiteral("Snapshot 4")); // a name is given once
}

void ComparisonTest::sideBySideShowsBothWhole()
{
    StudioWindow window;
    window.show();
    press(window, Qt::Key_S);
    QCOMPARE(window.preview().comparison(), Comparison::Off); // nothing to compare with
    press(window, Qt::Key_K, Qt::ControlModifier);
    press(window, Qt::Key_S);
    const QImage before = window.picture();
    QCOMPARE(before.size(), window.preview().size());
    const Halves same = halves(before);
    QVERIFY(largestDifference(same.kept, same.now) <= 1); // the last bit may depend on where in the window a picture lies
    QVERIFY(largestDifference(same.now, drawn(window, same.now.size())) <= 1);

    makeGold(window);
    const Halves pair = halves(window.picture());
    QVERIFY(largestDifference(pair.kept, same.kept) <= 1);
    QVERIFY(largestDifference(pair.now, drawn(window, pair.now.size())) <= 1);
    QVERIFY(largestDifference(pair.now, pair.kept) > 20);

    window.document().edit(QStringLiteral("turn"), {}, [](Scene& scene) { scene.view.camera.yawDeg += 40; }); // both turn
    const Halves turned = halves(window.picture());
    QVERIFY(largestDifference(turned.kept, pair.kept) > 20);
    QVERIFY(largestDifference(turned.now, drawn(window, turned.now.size())) <= 1);
    press(window, Qt::Key_S);
    QCOMPARE(window.preview().comparison(), Comparison::Off);
    QVERIFY(largestDifference(window.picture(), drawn(window, window.preview().size())) <= 1);
}

void ComparisonTest::thePictureSaysWhichIsWhich()
{
    StudioWindow window;
    window.show();
    QVERIFY(!label(window, "compare.a").isVisible());
    press(window, Qt::Key_K, Qt::ControlModifier);
    snapshots(window).rename(0, QStringLiteral("clay"));
    makeGold(window);
    const int middle = window.preview().width() / 2;
    press(window, Qt::Key_S);
    window.waitForPicture();
    QCOMPARE(label(window, "compare.a").text(), QStringLiteral("A: clay"));
    QCOMPARE(label(window, "compare.b").text(), QStringLiteral("B: now"));
    QVERIFY(label(window, "compare.a").isVisible() && label(window, "compare.a").geometry().right() < middle);
    QVERIFY(label(window, "compare.b").isVisible() && label(window, "compare.b").x() > middle);
    QVERIFY(waitForFigures(window));
    keepScreenshot(*window, QStringLiteral("compare-side"));

    press(window, Qt::Key_W);
    const int line = static_cast<int>(0.3 * window.preview().width());
    window.preview().setWipe(0.3);
    QVERIFY(label(window, "compare.a").geometry().right() < line);
    QVERIFY(label(window, "compare.b").x() > line);
    window.preview().setWipe(0.0); // there is no A to name
    QVERIFY(!label(window, "compare.a").isVisible());
    keepScreenshot(*window, QStringLiteral("compare-wipe"));
    press(window, Qt::Key_D);
    QVERIFY(label(window, "compare.a").text().contains(QStringLiteral("clay")));
    QVERIFY(!label(window, "compare.b").isVisible());
    keepScreenshot(*window, QStringLiteral("compare-difference"));
    press(window, Qt::Key_D);
    QVERIFY(!label(window, "compare.a").isVisible() && !label(window, "compare.figures").isVisible());

    snapshots(window).rename(0, QString(200, u'm')); // a name too long for its half is cut in the middle, and stays inside
    press(window, Qt::Key_S);
    QVERIFY(label(window, "compare.a").geometry().right() < middle);
    QVERIFY(label(window, "compare.a").text().contains(u'…'));
}

void ComparisonTest::theFiguresAreThoseOfWhatIsShown()
{
    StudioWindow window;
    window.show();
    press(window, Qt::Key_K, Qt::ControlModifier);
    press(window, Qt::Key_S);
    window.waitForPicture();
    QVERIFY(waitForFigures(window));
    QCOMPARE(snapshots(window).error()->relRms, 0.0);
    QVERIFY(std::isinf(snapshots(window).error()->psnr));
    QVERIFY(std::abs(snapshots(window).error()->ssim - 1.0) < 1e-12);
    QVERIFY(label(window, "compare.figures").text().contains(QStringLiteral("PSNR ∞ dB, SSIM 1.0000")));

    makeGold(window);
    const Halves pair = halves(window.picture());
    QVERIFY(waitForFigures(window));
    QVERIFY(areAlike(*snapshots(window).error(), pictureError(values(pair.now), values(pair.kept)))); // A is the reference
    QCOMPARE(label(window, "compare.figures").text(), errorText(snapshots(window).error()));
    list(window);
    QCOMPARE(window->findChild<QLabel*>(QStringLiteral("snapshots.figures"))->text(), errorText(snapshots(window).error()));

    // A wipe shows a part of each; measured are the two whole, wherever its line stands.
    press(window, Qt::Key_W);
    window.waitForPicture();
    QVERIFY(waitForFigures(window));
    const PictureError wiped = *snapshots(window).error();
    press(window, Qt::Key_W);
    const QImage now = window.picture();
    press(window, Qt::Key_B); // a glance is over when the key is up
    QTest::keyPress(&window.preview(), Qt::Key_B);
    const QImage kept = window.picture();
    QTest::keyRelease(&window.preview(), Qt::Key_B);
    QVERIFY(areAlike(wiped, pictureError(values(now), values(kept))));
}

void ComparisonTest::theFiguresWaitWhileSomethingMoves()
{
    StudioWindow window;
    window.show();
    press(window, Qt::Key_K, Qt::ControlModifier);
    makeGold(window);
    press(window, Qt::Key_D);
    window.waitForPicture();
    QVERIFY(waitForFigures(window));
    window.document().edit(QStringLiteral("orbit"), QStringLiteral("orbit"), [](Scene& scene) { scene.view.camera.yawDeg += 10; });
    QTRY_VERIFY_WITH_TIMEOUT(!snapshots(window).error(), patience);
    QCOMPARE(label(window, "compare.figures").text(), QStringLiteral("measuring…"));
    QTest::qWait(300);
    QVERIFY(!snapshots(window).error()); // the hand has not let go
    window.document().finishEdit();
    QVERIFY(waitForFigures(window));
}

void ComparisonTest::aSnapshotIsBroughtBackInOneStep()
{
    StudioWindow window;
    window.show();
    const QImage clay = window.picture();
    press(window, Qt::Key_K, Qt::ControlModifier);
    makeGold(window);
    window.document().edit(QStringLiteral("torus"), {}, [](Scene& scene) { scene.view.geometry = "torus"; });
    window.document().edit(QStringLiteral("export"), {}, [](Scene& scene) { scene.exports.push_back({.name = "map"}); });
    const Scene before = window.document().scene();
    list(window);
    QTRY_VERIFY_WITH_TIMEOUT(window->findChild<QPushButton*>(QStringLiteral("snapshots.back"))->isVisible(), patience);
    QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("snapshots.back")), Qt::LeftButton);
    QVERIFY(largestDifference(window.picture(), clay) <= 1);
    QCOMPARE(window.document().scene().exports.size(), size_t(1)); // what is to be written is no look
    QCOMPARE(window.document().undoStack().count(), 4);
    window.document().undoStack().undo();
    QVERIFY(window.document().scene() == before);
}

// A path that began at another folder still leads to its file.
void ComparisonTest::aSnapshotKeepsItsFolder()
{
    const TemporaryFolder one, other;
    writeImage(one / "room.hdr", renderBuiltinProbe("cube-room", {Parameterization::Latlong, 64, 0}).image);
    StudioWindow window;
    window.document().edit(QStringLiteral("room"), {}, [&](Scene& scene) { scene.probe.source = (one / "room.hdr").string(); });
    window.document().save(fromPath(one / "a.mirrorball"));
    QCOMPARE(window.document().scene().probe.source, std::string("room.hdr"));
    window.show();
    const QImage room = window.picture();
    press(window, Qt::Key_K, Qt::ControlModifier);
    window.document().reset();
    window.document().save(fromPath(other / "b.mirrorball"));
    list(window);
    QTRY_VERIFY_WITH_TIMEOUT(window->findChild<QPushButton*>(QStringLiteral("snapshots.back"))->isVisible(), patience);
    QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("snapshots.back")), Qt::LeftButton);
    QVERIFY(largestDifference(window.picture(), room) <= 1);
    QVERIFY(window->workspace().live.made()->problem.empty());
    window.document().save(fromPath(other / "b.mirrorball"));
    QVERIFY(largestDifference(window.picture(), room) <= 1);
}

// A sphere seen from the front has the disc's middle in its own.
void ComparisonTest::sideBySideThePenTouchesWhatIsShownNow()
{
    StudioWindow window;
    window.document().edit(QStringLiteral("sphere"), {}, [](Scene& scene) { scene.view.geometry = "sphere"; });
    window.show();
    press(window, Qt::Key_K, Qt::ControlModifier);
    const QSizeF size = window.preview().size();
    const auto place = [&](double x) {
        return window.preview().discPlaceAt({x * size.width(), 0.5 * size.height()}, SphereMapIndex::Normal);
    };
    QVERIFY(place(0.5) && glm::length(*place(0.5)) < 0.02);
    press(window, Qt::Key_S);
    window.waitForPicture();
    QVERIFY(!place(0.25)); // what was kept is not painted on
    QVERIFY(place(0.75) && glm::length(*place(0.75)) < 0.02);
}

} // namespace mirrorball::test
