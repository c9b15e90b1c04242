#include "open_files_test.h"

#include "file_dialog_answer.h"
#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/scene/scene_file.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/text.h"
#include "widgets/files/recent_files.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<OpenFilesTest> registered;

void OpenFilesTest::init() { QSettings().clear(); }

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string gltf = R"({"asset": {"version": "2.0"}, "scenes": []})";
const std::string material = R"({"specular": {"lobe": "phong", "exponent": 33}})";

/// One file of each kind.
struct Files {
    TemporaryFolder folder;
    QString scene, probe, mesh, sphereMap, material;

    Files()
    {
        Scene other;
        other.view.exposure = 2.5;
        saveScene(other, folder / "other.mirrorball");
        writeImage(folder / "sky.hdr", renderBuiltinProbe("sky", {Parameterization::Latlong, 32, 0}).image);
        writeBytes(folder / "triangle.obj", triangle);
        saveSphereMap(sphereMapPresets().front().document, folder / "toon.spheremap");
        writeBytes(folder / "glossy.material", test::material);
        scene = fromPath(folder / "other.mirrorball");
        probe = fromPath(folder / "sky.hdr");
        mesh = fromPath(folder / "triangle.obj");
        sphereMap = fromPath(folder / "toon.spheremap");
        material = fromPath(folder / "glossy.material");
    }
    QStringList all() const { return {scene, probe, mesh, sphereMap, material}; }
};

/// Ctrl+O, as the user does it.
QString openByKeys(StudioWindow& window, const QString& path)
{
    QApplication::setActiveWindow(&*window); // as a window manager would, when the dialog before has closed
    FileDialogAnswer answer(path);
    QTest::keyClick(&*window, Qt::Key_O, Qt::ControlModifier);
    return answer.isDone() ? answer.folder() : QStringLiteral("no dialog");
}

void verifyAllOpen(StudioWindow& window, const Files& files)
{
    const Scene& scene = window.document().scene();
    QCOMPARE(scene.view.exposure, 2.5); // of the scene file, which came first
    QCOMPARE(QString::fromStdString(scene.probe.source), files.probe);
    QCOMPARE(QString::fromStdString(scene.view.geometry), files.mesh);
    QCOMPARE(scene.material.specular.exponent, 33.0);
}

} // namespace

// ---- kinds ---------------------------------------------------------------------------------------------------------------------

void OpenFilesTest::theKindOfAFileIsWhatItHolds_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<FileKind>("kind");
    const auto row = [](const char* what, const char* name, const QByteArray& bytes, FileKind kind) {
        QTest::newRow(what) << QString::fromLatin1(name) << bytes << kind;
    };
    // Signatures and keys as the formats' own documents have them.
    const QByteArray hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
    row("Radiance", "a.hdr", hdr, FileKind::Picture);
    row("Radiance with a scene's ending", "a.mirrorball", hdr, FileKind::Picture);
    row("OpenEXR without an ending", "a", QByteArray("\x76\x2f\x31\x01\x02\0\0\0", 8), FileKind::Picture);
    row("PNG with a mesh's ending", "a.obj", "\x89PNG\r\n\x1a\n", FileKind::Picture);
    row("JPEG", "a.dat", "\xff\xd8\xff\xe0", FileKind::Picture);
    row("scene", "a.mirrorball", R"({"version": 1, "probe": {"source": "builtin:sky"}})", FileKind::Scene);
    row("scene with another ending", "a.json", R"( {"version": 1, "view": {}})", FileKind::Scene);
    row("scene that says nothing", "a.mirrorball", R"({"version": 1})", FileKind::Scene);
    row("scene that is broken", "a.mirrorball", "{\"version\": 1, ", FileKind::Scene);
    row("material", "a.json", material.c_str(), FileKind::Material);
    row("keys inside are not the file's own", "a.json", R"({"diffuse": {"layers": [], "probe": 1}})", FileKind::Material);
    row("brackets and quotes inside texts", "a.json", R"({"x}": "\"{", "lambda": 1})", FileKind::Material);
    row("sphere map", "a.txt", R"({"version": 1, "title": "view", "layers": []})", FileKind::SphereMap);
    row("strokes", "a.json", R"({"version": 1, "strokes": []})", FileKind::SphereMap);
    row("glTF", "a.gltf", gltf.c_str(), FileKind::Mesh);
    row("glTF with another ending", "a.json", gltf.c_str(), FileKind::Mesh);
    row("mesh", "a.OBJ", triangle.c_str(), FileKind::Mesh);
    row("OpenColorIO", "a.txt", "ocio_profile_version: 2\n", FileKind::Display);
    row("a text", "notes.txt", "{ dear diary }", FileKind::Unknown);
    row("a list", "list.txt", R"(["probe", "view"])", FileKind::Unknown);
    row("nothing", "empty", "", FileKind::Unknown);
}

void OpenFilesTest::theKindOfAFileIsWhatItHolds()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(FileKind, kind);
    const TemporaryFolder folder;
    writeBytes(folder / name.toStdString(), bytes.toStdString());
    QCOMPARE(fileKind(fromPath(folder / name.toStdString())), kind);
}

void OpenFilesTest::theKindOfWhatIsNotThereIsItsEnding()
{
    const TemporaryFolder folder;
    QCOMPARE(fileKind(fromPath(folder.path())), FileKind::Folder);
    QCOMPARE(fileKind(fromPath(folder / "gone.mirrorball")), FileKind::Scene);
    QCOMPARE(fileKind(fromPath(folder / "face_%s.exr")), FileKind::Picture);
    for (const FileKind kind : {FileKind::Scene, FileKind::Material, FileKind::SphereMap, FileKind::Mesh, FileKind::Picture})
        for (const QString& pattern : patternsOf(kind)) {
            QCOMPARE(fileKind(QStringLiteral("/nowhere/x") + pattern.mid(1)), kind);
            QVERIFY2(openFilter().section(QStringLiteral(";;"), 0, 0).contains(pattern), qPrintable(pattern));
        }
}

// ---- opening -------------------------------------------------------------------------------------------------------------------

void OpenFilesTest::oneDialogOpensEveryKind()
{
    const Files files;
    StudioWindow window;
    window.show();
    openByKeys(window, files.scene);
    QCOMPARE(window.document().filePath(), files.scene);
    openByKeys(window, files.probe);
    openByKeys(window, files.mesh);
    openByKeys(window, files.material);
    verifyAllOpen(window, files);
    openByKeys(window, files.sphereMap);
    QVERIFY(window->workspace().sphereMap.map());
    QCOMPARE(window->workspace().sphereMap.map()->layers.size(), sphereMapPresets().front().document.layers.size());
    QTRY_VERIFY(window->dock(QStringLiteral("sphere-map"))->widget()->isVisible()); // to see what was opened
    QVERIFY(window->workspace().notices.all().isEmpty());
    window.waitForPicture();
    keepScreenshot(*window, QStringLiteral("opened-every-kind"));
}

void OpenFilesTest::recentFilesAreOneListOfAllKinds()
{
    const Files files;
    StudioWindow window;
    window.show();
    window->openFiles(files.all());
    window->openFiles({files.probe}); // again: it comes to the front, and is there once
    auto* menu = window->findChild<QMenu*>(QStringLiteral("file.recent"));
    QVERIFY(menu);
    emit menu->aboutToShow();
    QStringList shown;
    for (const QAction* action : menu->actions())
        shown << action->text();
    QCOMPARE(shown, (QStringList{QStringLiteral("sky.hdr  (picture)"), QStringLiteral("glossy.material  (material)"),
                                 QStringLiteral("toon.spheremap  (sphere map)"), QStringLiteral("triangle.obj  (mesh)"),
                                 QStringLiteral("other.mirrorball  (scene)")}));
    window.document().reset();
    menu->actions()[3]->trigger();
    QCOMPARE(QString::fromStdString(window.document().scene().view.geometry), files.mesh);
    // What panels open and save is in it, too.
    QVERIFY(window->files().saveAs(fromPath(files.folder / "saved.mirrorball")));
    QCOMPARE(recentFiles().front(), (RecentFile{fromPath(files.folder / "saved.mirrorball"), FileKind::Scene}));
}

void OpenFilesTest::aRecentFileThatIsGoneIsNamedAndLeavesTheList()
{
    const Files files;
    StudioWindow window;
    window->openFiles(files.all());
    QVERIFY(QFile::remove(files.mesh));
    auto* menu = window->findChild<QMenu*>(QStringLiteral("file.recent"));
    emit menu->aboutToShow();
    const auto actions = menu->actions();
    const auto gone = std::find_if(actions.begin(), actions.end(), [](const QAction* a) { return a->text().startsWith(u"triangle"); });
    QVERIFY(gone != actions.end());
    window.document().reset();
    (*gone)->trigger();
    QCOMPARE(window.document().scene().view.geometry, std::string("teapot"));
    QCOMPARE(window->workspace().notices.all().size(), 1);
    QVERIFY(window->workspace().notices.all().front().text.contains(QStringLiteral("triangle.obj: there is no such file")));
    for (const RecentFile& file : recentFiles())
        QVERIFY(file.path != files.mesh);
}

void OpenFilesTest::dialogsRememberTheirFolders()
{
    const Files files;
    const TemporaryFolder pictures;
    {
        StudioWindow window;
        window.show();
        openByKeys(window, files.probe);
        QCOMPARE(openByKeys(window, files.mesh), fromPath(files.folder.path()));
        FileDialogAnswer save(fromPath(pictures / "a.png"));
        QTest::keyClick(&*window, Qt::Key_F12);
        QVERIFY(save.isDone());
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(pictures / "a.png"), 60000);
        QCOMPARE(openByKeys(window, files.probe), fromPath(files.folder.path())); // not where the picture went
    }
    StudioWindow again; // the next run
    again.show();
    QCOMPARE(openByKeys(again, files.mesh), fromPath(files.folder.path()));
    QCOMPARE(rememberedFolder(QStringLiteral("picture")), fromPath(pictures.path()));
}

void OpenFilesTest::theCommandLineOpensEveryKind()
{
    const Files files;
    StudioWindow window;
    window->openFiles(files.all()); // what main() does with its arguments
    verifyAllOpen(window, files);
    QVERIFY(window->workspace().notices.all().isEmpty());
    window->openFiles({fromPath(files.folder / "nothing.exr"), QStringLiteral(MIRRORBALL_TRANSLATIONS)});
    QCOMPARE(window->workspace().notices.all().size(), 1);
    const QString notice = window->workspace().notices.all().front().text;
    QVERIFY2(notice.contains(QStringLiteral("nothing.exr")) && notice.contains(QStringLiteral("mirrorball-studio_en.ts")),
             qPrintable(notice));
}

void OpenFilesTest::everyKindCanBeDropped()
{
    const Files files;
    StudioWindow window;
    window.show();
    QVERIFY(dropFiles(*window, files.all()));
    verifyAllOpen(window, files);
    QVERIFY(window->workspace().notices.all().isEmpty());
}

} // namespace mirrorball::test
