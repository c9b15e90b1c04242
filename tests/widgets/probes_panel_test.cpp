#include "probes_panel_test.h"

#include "widget_driver.h"

#include "studio_window.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "support/temporary_folder.h"
#include "widgets/panels/probes_panel.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>

#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ProbesPanelTest> registered;

namespace {

struct ShownPanel {
    explicit ShownPanel(const QSize& size = {340, 680})
    {
        panel = std::make_unique<ProbesPanel>(workspace);
        panel->resize(size);
        panel->show();
        isReady = QTest::qWaitForWindowExposed(panel.get());
    }
    QModelIndex row(const QString& name) const
    {
        const QAbstractItemModel& model = *panel->list().model();
        for (int i = 0; i < model.rowCount(); ++i)
            if (model.index(i, 0).data().toString() == name)
                return model.index(i, 0);
        return {};
    }
    bool settle()
    {
        return QTest::qWaitFor([&] { return panel->details().isSurveyed() && !workspace.library.isBusy(); }, patience);
    }
    void click(const QString& name)
    {
        panel->list().scrollTo(row(name));
        QTest::mouseClick(panel->list().viewport(), Qt::LeftButton, {}, panel->list().visualRect(row(name)).center());
    }
    const ProbeSettings& probe() const { return workspace.document.scene().probe; }

    Workspace workspace;
    std::unique_ptr<ProbesPanel> panel;
    bool isReady = false;
};

/// A small file that is a probe beyond doubt.
QString writeProbe(const TemporaryFolder& folder, const std::string& name, const char* builtin = "cube-room",
                   const MapLayout& layout = {Parameterization::Latlong, 32, 0})
{
    writeImage(folder / name, renderBuiltinProbe(builtin, layout).image);
    return QString::fromStdString((folder / name).string());
}

} // namespace

void ProbesPanelTest::init() { QSettings().clear(); }

void ProbesPanelTest::listsTheBuiltInProbesWithThumbnails()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    QCOMPARE(shown.panel->list().model()->rowCount(), static_cast<int>(builtinProbes().size()));
    for (int i = 0; i < shown.panel->list().model()->rowCount(); ++i)
        QTRY_VERIFY(!shown.panel->list().model()->index(i, 0).data(Qt::DecorationRole).value<QImage>().isNull());
    QCOMPARE(shown.panel->list().currentIndex().data().toString(), QStringLiteral("studio"));
    keepScreenshot(*shown.panel, QStringLiteral("probes"));
}

void ProbesPanelTest::choosingAProbeIsAnUndoStep()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    shown.click(QStringLiteral("sky"));
    QCOMPARE(shown.probe().source, std::string("builtin:sky"));
    shown.workspace.document.undoStack().undo();
    QCOMPARE(shown.probe().source, std::string("builtin:studio"));
    QCOMPARE(shown.panel->list().currentIndex().data().toString(), QStringLiteral("studio"));
    QVERIFY(shown.settle());
}

void ProbesPanelTest::keysChooseToo()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    shown.panel->list().setFocus();
    QTest::keyClick(&shown.panel->list(), Qt::Key_End);
    QTest::keyClick(&shown.panel->list(), Qt::Key_Return);
    QCOMPARE(shown.probe().source, std::string("builtin:axes"));
    QVERIFY(shown.settle());
}

void ProbesPanelTest::tellsTheFactsOfTheProbe()
{
    const TemporaryFolder folder;
    Image image = renderBuiltinProbe("cube-room", {Parameterization::Latlong, 32, 0}).image;
    image.texel(10, 10)[0] = std::numeric_limits<float>::quiet_NaN();
    image.texel(40, 9)[1] = 1e5f;
    writeImage(folder / "facts.exr", image);
    ShownPanel shown;
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    opener.open({QString::fromStdString((folder / "facts.exr").string())});
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->details().factsText().contains(QStringLiteral("64 × 32")), patience);
    for (const char* fact : {"2:1, taken for a latlong", "1 NaN", "brightest 0.01 %", "beyond 65504"})
        QVERIFY2(shown.panel->details().factsText().contains(QLatin1String(fact)), qPrintable(shown.panel->details().factsText()));
}

void ProbesPanelTest::takesAFileThatIsDropped()
{
    const TemporaryFolder folder;
    const QString file = writeProbe(folder, "room.exr");
    StudioWindow window;
    window.show();
    QVERIFY(dropFiles(*window, {file}));
    QCOMPARE(QString::fromStdString(window.document().scene().probe.source), file);
    QVERIFY(window->workspace().library.rowOf(file) >= 0);
    window.waitForPicture();
    QTest::qWait(300);
    keepScreenshot(*window, QStringLiteral("window"));
    window->resize(1920, 1150);
    window.waitForPicture();
    QTest::qWait(1500);
    keepScreenshot(*window, QStringLiteral("window-large"));
    window.document().undoStack().undo();
    QCOMPARE(window.document().scene().probe.source, std::string("builtin:studio"));
}

void ProbesPanelTest::takesAFolderThatIsDroppedAndFollowsIt()
{
    const TemporaryFolder folder;
    writeProbe(folder, "one.exr");
    ShownPanel shown;
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    QVERIFY(dropFiles(*shown.panel, {QString::fromStdString(folder.path().string())}));
    QVERIFY(shown.row(QStringLiteral("one.exr")).isValid());
    writeProbe(folder, "two.exr", "sky");
    QTRY_VERIFY_WITH_TIMEOUT(shown.row(QStringLiteral("two.exr")).isValid(), patience);
    shown.click(QStringLiteral("two.exr"));
    QVERIFY(QString::fromStdString(shown.probe().source).endsWith(QStringLiteral("/two.exr")));
    QVERIFY(shown.settle());
    ProbeLibrary again; // the next run
    QVERIFY(again.rowOf(QString::fromStdString(shown.probe().source)) >= 0);
}

void ProbesPanelTest::refusesOtherFilesInWords()
{
    const TemporaryFolder folder;
    writeBytes(folder / "notes.txt", "no image");
    ShownPanel shown;
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    dropFiles(*shown.panel, {QString::fromStdString((folder / "notes.txt").string())});
    QCOMPARE(shown.workspace.notices.all().size(), 1);
    QVERIFY(shown.workspace.notices.all().front().text.contains(QStringLiteral("notes.txt")));
    QCOMPARE(shown.probe().source, std::string("builtin:studio"));
}

void ProbesPanelTest::offersAPictureOfEachGuess()
{
    const TemporaryFolder folder;
    const QString file = writeProbe(folder, "square.hdr", "studio", {Parameterization::Sphere, 64, 0});
    ShownPanel shown({380, 760});
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    opener.open({file});
    QTRY_COMPARE_WITH_TIMEOUT(shown.panel->details().guesses().size(), 3, patience);
    QVERIFY(shown.settle());
    for (const QToolButton* guess : shown.panel->details().guesses()) {
        QVERIFY(!guess->icon().isNull());
        QCOMPARE(guess->isChecked(), guess->objectName() == QStringLiteral("probes.guess.angular"));
    }
    keepScreenshot(*shown.panel, QStringLiteral("probes-guess"));
    shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.sphere"))->click();
    QCOMPARE(shown.probe().reading.parameterization, std::optional(Parameterization::Sphere));
    QVERIFY(shown.settle());
    QCOMPARE(shown.panel->details().guesses().size(), 3); // the choice stays open
    QVERIFY(shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.sphere"))->isChecked());
    QCOMPARE(shown.panel->findChild<QComboBox*>(QStringLiteral("probes.read_as"))->currentText(), QStringLiteral("Sphere"));
    shown.workspace.document.undoStack().undo();
    QVERIFY(!shown.probe().reading.parameterization);
}

void ProbesPanelTest::offersAMirrorBallForAPhotograph()
{
    const TemporaryFolder folder;
    Image photo(80, 60, 3, 0.02f);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            if (std::hypot(x - 45.0, y - 31.0) < 22.0)
                std::fill_n(photo.texel(x, y), 3, 0.8f);
    writeImage(folder / "photo.png", photo);
    ShownPanel shown({380, 760});
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    opener.open({QString::fromStdString((folder / "photo.png").string())});
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.ball")), patience);
    QVERIFY(shown.settle());
    auto* cross = shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.cube"));
    QVERIFY(cross && cross->isChecked()); // 4:3 is a cross' shape, too
    shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.ball"))->click();
    QCOMPARE(shown.probe().reading.parameterization, std::optional(Parameterization::Sphere));
    QVERIFY(shown.probe().reading.fit == Fit::Crop);
    QVERIFY(shown.settle());
    keepScreenshot(*shown.panel, QStringLiteral("probes-ball"));
    QVERIFY(shown.panel->findChild<QToolButton*>(QStringLiteral("probes.guess.ball"))->isChecked());
    shown.workspace.document.undoStack().undo();
    QVERIFY(shown.probe().reading == ProbeReading{});
}

void ProbesPanelTest::namesWhatIsBroken()
{
    const TemporaryFolder folder;
    writeBytes(folder / "broken.exr", "not an image");
    ShownPanel shown;
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    opener.open({QString::fromStdString((folder / "broken.exr").string())});
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->details().factsText().contains(QStringLiteral("broken.exr")), patience);
    QVERIFY(shown.settle());
    QTRY_VERIFY(!shown.row(QStringLiteral("broken.exr")).data(ProbeLibrary::ProblemRole).toString().isEmpty());
    shown.panel->list().scrollToBottom();
    keepScreenshot(*shown.panel, QStringLiteral("probes-broken"));
}

void ProbesPanelTest::readsAProbeAgainThatChangedOnDisk()
{
    const TemporaryFolder folder;
    const QString file = writeProbe(folder, "live.exr");
    ShownPanel shown;
    FileOpener opener(shown.workspace);
    DropTarget target(*shown.panel, opener);
    opener.open({file});
    QVERIFY(shown.settle());
    QTRY_VERIFY_WITH_TIMEOUT(shown.workspace.live.isUpToDate() && shown.workspace.live.made()->environment->image.height == 32, patience);
    writeProbe(folder, "live.exr", "sky", {Parameterization::Latlong, 64, 0}); // written beside it and renamed into place
    QTRY_VERIFY_WITH_TIMEOUT(shown.workspace.live.made()->environment->image.height == 64, patience);
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->details().factsText().contains(QStringLiteral("128 × 64")), patience);
    QFile::remove(file);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.workspace.live.made()->problem.empty(), patience);
    writeProbe(folder, "live.exr", "sky");
    QTRY_VERIFY_WITH_TIMEOUT(shown.workspace.live.made()->problem.empty(), patience);
}

void ProbesPanelTest::keepsThumbnailsOnDisk()
{
    QDir cache(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails"));
    cache.removeRecursively();
    const TemporaryFolder folder;
    const QString file = writeProbe(folder, "kept.exr");
    const auto thumbnail = [&] {
        ProbeLibrary library;
        library.addFile(file);
        const QModelIndex index = library.index(library.rowOf(file));
        index.data(Qt::DecorationRole);
        return QTest::qWaitFor([&] { return !index.data(Qt::DecorationRole).value<QImage>().isNull(); }, patience)
                   ? index.data(Qt::DecorationRole).value<QImage>()
                   : QImage();
    };
    const QImage first = thumbnail();
    cache.refresh();
    QCOMPARE(cache.entryList(QDir::Files).size(), 1);
    QVERIFY(!first.isNull());
    QCOMPARE(thumbnail(), first);
    QCOMPARE(cache.entryList(QDir::Files).size(), 1);
}

void ProbesPanelTest::saysWhyAListIsEmpty()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    auto* group = shown.panel->findChild<QComboBox*>(QStringLiteral("probes.group"));
    group->setCurrentIndex(group->findData(ProbeLibrary::filesGroup()));
    QVERIFY(!shown.panel->list().isVisible());
    QVERIFY(shown.settle());
    keepScreenshot(*shown.panel, QStringLiteral("probes-empty"));
    group->setCurrentIndex(0);
    QVERIFY(shown.panel->list().isVisible());
    shown.panel->findChild<QLineEdit*>(QStringLiteral("probes.find"))->setText(QStringLiteral("sk"));
    QCOMPARE(shown.panel->list().model()->rowCount(), 1);
}

void ProbesPanelTest::namesAllControls()
{
    ShownPanel shown;
    const QStringList names = unexplained(*shown.panel);
    QVERIFY2(names.isEmpty(), qPrintable(names.join(u'\n')));
}

void ProbesPanelTest::filesThatAreGoneCanBeTakenOffTheList()
{
    const TemporaryFolder folder;
    ShownPanel shown;
    QVERIFY(shown.isReady);
    const int builtin = shown.panel->list().model()->rowCount();
    QStringList files;
    for (const char* name : {"one.exr", "two.exr", "three.exr"}) {
        files << writeProbe(folder, name);
        shown.workspace.library.addFile(files.back());
    }
    QVERIFY(shown.settle());
    std::filesystem::remove(folder / "one.exr");
    std::filesystem::remove(folder / "two.exr");
    QCOMPARE(shown.workspace.library.missingFiles(), (QStringList{files[0], files[1]}));

    QListView& list = shown.panel->list();
    QApplication::setActiveWindow(list.window()); // as a window manager would
    list.setFocus();
    list.setCurrentIndex(shown.row(QStringLiteral("one.exr")));
    QTest::keyClick(&list, Qt::Key_Delete);
    QVERIFY(!shown.row(QStringLiteral("one.exr")).isValid());
    auto* removeMissing = shown.panel->findChild<QAction*>(QStringLiteral("probes.remove-missing"));
    QVERIFY(removeMissing);
    removeMissing->trigger();
    QVERIFY(!shown.row(QStringLiteral("two.exr")).isValid());
    QVERIFY(shown.row(QStringLiteral("three.exr")).isValid());
    list.setCurrentIndex(shown.row(QStringLiteral("studio"))); // built in: stays
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(list.model()->rowCount(), builtin + 1);
    QVERIFY(ProbeLibrary().missingFiles().isEmpty()); // the next run knows
}

} // namespace mirrorball::test
