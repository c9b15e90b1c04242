#include "recovery_test.h"

#include "app/studio/recovery.h"
#include "core/scene/scene_file.h"
#include "studio_window.h"
#include "support/temporary_folder.h"
#include "widgets/controls/text.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QPushButton>

#include <csignal>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<RecoveryTest> registered;

static void change(Document& document)
{
    document.edit(QStringLiteral("change"), {}, [](Scene& scene) { scene.view.exposure = scene.view.exposure == 1.0 ? 2.0 : 1.0; });
}

void saveForever(const QString& file, const QString& folder)
{
    Document document;
    document.save(file);
    Recovery recovery(document, folder);
    change(document);
    while (!QFile::exists(recovery.copyPath())) // the first copy
        QTest::qWait(20);
    Scene scene = document.scene();
    saveScene(scene, toPath(file));
    QFile(folder + QStringLiteral("/ready")).open(QFile::WriteOnly);
    for (int i = 0;; ++i) {
        scene.view.camera.yawDeg = i % 360;
        saveScene(scene, toPath(file)); // as Document::save() does, which would take the copy away
    }
}

void RecoveryTest::keepsUnsavedChangesAndDropsSavedOnes()
{
    const TemporaryFolder folder;
    Document document;
    Recovery recovery(document, fromPath(folder.path()));
    change(document);
    QTRY_VERIFY(QFile::exists(recovery.copyPath()));
    QCOMPARE(loadScene(toPath(recovery.copyPath())).view.exposure, 1.0);
    document.save(fromPath(folder / "saved.scene.mirrorball"));
    QTRY_VERIFY(!QFile::exists(recovery.copyPath()));
}

void RecoveryTest::leavesNothingAfterAnOrderlyEnd()
{
    const TemporaryFolder folder;
    {
        Document document;
        Recovery recovery(document, fromPath(folder.path()));
        change(document);
        QTRY_VERIFY(QFile::exists(recovery.copyPath()));
        Document other;
        QVERIFY(Recovery(other, fromPath(folder.path())).found().empty()); // its program lives
    }
    QVERIFY(QDir(fromPath(folder.path())).isEmpty());
}

// Whenever the program is killed, the file is one that was saved whole, and the copy of its changes is found.
void RecoveryTest::offersWhatAKilledProgramLeft()
{
    for (const int delay : {0, 3, 11, 26}) {
        const TemporaryFolder folder;
        const QString file = fromPath(folder / "scene.mirrorball"), copies = fromPath(folder / "copies");
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--save-forever"), file, copies});
        QVERIFY(program.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(copies + QStringLiteral("/ready")), 30000);
        QTest::qWait(delay);
        ::kill(static_cast<pid_t>(program.processId()), SIGKILL);
        QVERIFY(program.waitForFinished());

        const Scene whole = loadScene(toPath(file)); // throws when it is not
        QCOMPARE(whole.view.exposure, 1.0);
        Document document;
        Recovery recovery(document, copies);
        const std::vector<Recovery::Found> found = recovery.found();
        QCOMPARE(found.size(), size_t{1});
        QCOMPARE(found.front().original, file);
        recovery.restore(found.front());
        QCOMPARE(document.scene().view.exposure, 1.0);
        QCOMPARE(document.filePath(), file);
        QVERIFY(document.isModified());
        QVERIFY(document.scene().unknown.empty());
        QVERIFY(recovery.found().empty());
    }
}

// Two programs have changed one document: neither takes the other's changes for left behind, nor away with its own, until the other is
// gone.
void RecoveryTest::leavesAloneWhatAnotherLivingProgramChanges()
{
    const TemporaryFolder folder;
    const QString file = fromPath(folder / "scene.mirrorball"), copies = fromPath(folder / "copies");
    const auto copiesThere = [&] { return QDir(copies).entryList({QStringLiteral("*.mirrorball")}, QDir::Files); };
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--save-forever"), file, copies});
    QVERIFY(program.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(copies + QStringLiteral("/ready")), 30000);
    const QStringList others = copiesThere();
    QCOMPARE(others.size(), 1);
    {
        Document document;
        document.load(file);
        Recovery recovery(document, copies);
        QVERIFY(recovery.found().empty());
        document.edit(QStringLiteral("turn"), {}, [](Scene& scene) { scene.view.exposure = -3.0; });
        QTRY_VERIFY(QFile::exists(recovery.copyPath()));
        QVERIFY(recovery.found().empty());
    }
    QCOMPARE(copiesThere(), others); // ours went, theirs did not
    program.kill();
    QVERIFY(program.waitForFinished());
    Document document;
    const std::vector<Recovery::Found> found = Recovery(document, copies).found();
    QCOMPARE(found.size(), size_t{1});
    QCOMPARE(loadScene(toPath(found.front().copy)).view.exposure, 1.0);
}

} // namespace mirrorball::test
