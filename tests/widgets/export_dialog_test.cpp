#include "export_dialog_test.h"

#include "patience.h"
#include "widget_driver.h"

#include "support/temporary_folder.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/exports/export_format.h"

#include <QClipboard>
#include <QFileInfo>
#include <QMenu>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>

#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ExportDialogTest> registered;

namespace {

Scene exportingScene()
{
    Scene scene;
    scene.probe.source = "builtin:cube-room";
    scene.probe.yawDeg = 30.0;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    scene.exports = {
        {.name = "env", .kind = ExportKind::Source, .parameterization = Parameterization::Octahedral, .size = 64, .mips = true},
        {.name = "gloss",
         .kind = ExportKind::Specular,
         .parameterization = Parameterization::Paraboloid,
         .size = 32,
         .border = 2,
         .half = true},
        {.name = "matt", .kind = ExportKind::Diffuse, .size = 16, .file = "matt_%s.hdr"}};
    return scene;
}

struct ShownDialog {
    explicit ShownDialog(const Scene& scene = exportingScene(), const QSize& size = {})
    {
        workspace.document.reset(scene);
        dialog = std::make_unique<ExportDialog>(workspace);
        if (size.isValid())
            dialog->resize(size);
        dialog->setFolder(QString::fromStdString((folder / "out").string()));
        dialog->show();
        isReady = QTest::qWaitForWindowExposed(dialog.get()) && QTest::qWaitFor([&] { return dialog->isEstimated(); }, patience);
    }
    template <typename T>
    T* find(const char* name)
    {
        return dialog->findChild<T*>(QLatin1String(name));
    }
    void choose(const char* combo, int index)
    {
        auto* box = find<QComboBox>(combo);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    const ExportTarget& target(size_t i) { return workspace.document.scene().exports.at(i); }
    /// Exports and waits for the end; the files written, or nothing when it failed.
    QStringList exports()
    {
        QSignalSpy exported(dialog.get(), &ExportDialog::exported);
        QTest::mouseClick(find<QPushButton>("export.start"), Qt::LeftButton);
        const bool isDone = QTest::qWaitFor([&] { return !dialog->isExporting(); }, patience);
        return !isDone || exported.isEmpty() ? QStringList() : exported.front().front().toStringList();
    }

    TemporaryFolder folder;
    Workspace workspace;
    std::unique_ptr<ExportDialog> dialog;
    bool isReady = false;
};

} // namespace

void ExportDialogTest::init() { QSettings().clear(); }

void ExportDialogTest::everyChangeIsAnUndoStepOfTheScene()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    const Scene before = shown.workspace.document.scene();
    shown.choose("export.parameterization", static_cast<int>(Parameterization::Paraboloid));
    QCOMPARE(shown.target(0).parameterization, Parameterization::Paraboloid);
    shown.find<QSpinBox>("export.size")->setFocus();
    QTest::keyClick(shown.find<QSpinBox>("export.size"), Qt::Key_Up); // doubles
    QCOMPARE(shown.target(0).size, 128);
    shown.find<QSpinBox>("export.border")->setValue(3);
    QCOMPARE(shown.target(0).border, 3);
    shown.choose("export.kind", 3);
    QCOMPARE(shown.target(0).kind, ExportKind::Chain);
    QVERIFY(!shown.find<QCheckBox>("export.mips")->isVisible());
    shown.find<QSpinBox>("export.levels")->setValue(4);
    QCOMPARE(shown.target(0).levels, 4);
    shown.find<QLineEdit>("export.name")->setText(QStringLiteral("glossy"));
    emit shown.find<QLineEdit>("export.name")->editingFinished();
    QCOMPARE(shown.target(0).name, std::string("glossy"));
    shown.dialog->list().add(ExportKind::Diffuse);
    shown.dialog->list().duplicateSelected();
    QCOMPARE(shown.workspace.document.scene().exports.size(), 5u);
    QVERIFY(shown.target(3).name != shown.target(4).name);
    shown.dialog->list().removeSelected();
    QCOMPARE(shown.workspace.document.scene().exports.size(), 4u);
    QCOMPARE(shown.workspace.document.undoStack().count(), 9);
    while (shown.workspace.document.undoStack().canUndo())
        shown.workspace.document.undoStack().undo();
    QVERIFY(shown.workspace.document.scene() == before);
    QCOMPARE(shown.find<QTreeWidget>("export.list")->topLevelItemCount(), 3);
}

void ExportDialogTest::keepsFormatsAndFileNamesTogether()
{
    const ExportTarget plain{.name = "maps"};
    QCOMPARE(formatOf(plain), 0);
    for (size_t i = 0; i < exportFormats().size(); ++i) {
        const ExportTarget target = withFormat(plain, exportFormats()[i]);
        QCOMPARE(formatOf(target), static_cast<int>(i));
        QCOMPARE(QString::fromStdString(target.fileName()), QStringLiteral("maps") + exportFormats()[i].extension);
        const ExportTarget six = withCubeFiles(target, CubeFiles::Six);
        QCOMPARE(QString::fromStdString(six.fileName()), QStringLiteral("maps_%s") + exportFormats()[i].extension);
        QVERIFY(withCubeFiles(six, CubeFiles::One) == target);
    }
    QVERIFY(withFormat(withFormat(plain, exportFormats()[2]), exportFormats()[0]) == plain); // an empty file name says the default
    QCOMPARE(freeName({plain, {.name = "maps-2"}}, "maps"), std::string("maps-3"));
}

void ExportDialogTest::namesTheFilesAndSizesBeforehand()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    QVERIFY2(shown.dialog->estimateText().contains(QStringLiteral("11 files")),
             qPrintable(shown.dialog->estimateText())); // 1 + 1 + 6, and three .json
    keepScreenshot(*shown.dialog, QStringLiteral("export"));
    const QString before = shown.dialog->estimateText();
    shown.find<QSpinBox>("export.size")->setValue(512);
    QTRY_VERIFY(shown.dialog->estimateText() != before);
    shown.dialog->resize(940, 560);
    keepScreenshot(*shown.dialog, QStringLiteral("export-small"));
}

void ExportDialogTest::itsCommandLineWritesTheSameBytes()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    QVERIFY(!shown.find<QPushButton>("export.copy")->isEnabled()); // there is no file that a command could read
    keepScreenshot(*shown.dialog, QStringLiteral("export-unsaved"));
    QSignalSpy save(shown.dialog.get(), &ExportDialog::saveRequested);
    shown.find<QPushButton>("export.save")->click();
    QCOMPARE(save.count(), 1);
    shown.workspace.document.save(QString::fromStdString((shown.folder / "it's a scene.mirrorball").string()));
    QVERIFY(shown.find<QPushButton>("export.copy")->isEnabled());
    const QStringList files = shown.exports();
    QCOMPARE(files.size(), 11);
    keepScreenshot(*shown.dialog, QStringLiteral("export-done"));

    // The same command into another folder, as a user pastes it into a shell.
    shown.dialog->setFolder(QString::fromStdString((shown.folder / "by hand").string()));
    shown.find<QPushButton>("export.copy")->click();
    const QString command = QGuiApplication::clipboard()->text();
    QCOMPARE(command, shown.dialog->command());
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PATH"),
                       QFileInfo(QStringLiteral(MIRRORBALL_PROGRAM)).absolutePath() + u':' + environment.value(QStringLiteral("PATH")));
    shell.setProcessEnvironment(environment);
    shell.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), command});
    QVERIFY(shell.waitForFinished(patience));
    QCOMPARE(shell.exitCode(), 0);
    for (const QString& file : files) {
        const std::string name = QFileInfo(file).fileName().toStdString();
        const std::string here = readBytes(shown.folder / "out" / name), there = readBytes(shown.folder / "by hand" / name);
        QVERIFY2(!here.empty() && here == there, name.c_str());
    }
}

void ExportDialogTest::writesOnlyWhatIsChecked()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    auto* list = shown.find<QTreeWidget>("export.list");
    list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
    list->topLevelItem(2)->setCheckState(0, Qt::Unchecked);
    QVERIFY(shown.dialog->command().endsWith(QStringLiteral("--only=gloss")));
    QCOMPARE(shown.exports().size(), 2);
    QVERIFY(std::filesystem::exists(shown.folder / "out" / "gloss.exr"));
    QVERIFY(!std::filesystem::exists(shown.folder / "out" / "env.exr"));
    list->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
    QVERIFY(!shown.find<QPushButton>("export.start")->isEnabled());
}

void ExportDialogTest::stopsWhenCancelled()
{
    Scene scene = exportingScene();
    scene.exports = {
        {.name = "long", .kind = ExportKind::Chain, .parameterization = Parameterization::Latlong, .size = 4096, .file = "long.hdr"}};
    ShownDialog shown(scene);
    QVERIFY(shown.isReady);
    QTest::mouseClick(shown.find<QPushButton>("export.start"), Qt::LeftButton);
    QVERIFY(shown.dialog->isExporting());
    QTest::qWait(150);
    keepScreenshot(*shown.dialog, QStringLiteral("export-running"));
    QTest::keyClick(shown.dialog.get(), Qt::Key_Escape); // stops the work, not the dialog
    QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->isExporting(), patience);
    QVERIFY(shown.dialog->isVisible());
    QVERIFY(shown.dialog->statusText().startsWith(QStringLiteral("Cancelled")));
    const std::filesystem::path out = shown.folder / "out";
    // The dialog is free at once; the work behind it ends with the row it is at, and takes what it had made away.
    QTRY_VERIFY_WITH_TIMEOUT(!std::filesystem::exists(out) || std::filesystem::is_empty(out), patience);
}

void ExportDialogTest::saysWhatIsWrong()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    shown.find<QLineEdit>("export.name")->setText(QStringLiteral("gloss")); // taken
    emit shown.find<QLineEdit>("export.name")->editingFinished();
    QVERIFY2(shown.dialog->statusText().contains(QStringLiteral("gloss")), qPrintable(shown.dialog->statusText()));
    QCOMPARE(shown.find<QLineEdit>("export.name")->text(), QStringLiteral("env"));
    writeBytes(shown.folder / "file", "in the way");
    shown.dialog->setFolder(QString::fromStdString((shown.folder / "file").string()));
    QVERIFY(shown.exports().isEmpty());
    QVERIFY2(shown.dialog->statusText().contains(QStringLiteral("file")), qPrintable(shown.dialog->statusText()));

    ShownDialog empty(Scene{});
    QVERIFY(empty.isReady);
    empty.dialog->chooseEngine({});
    QVERIFY(!empty.find<QPushButton>("export.start")->isEnabled());
    keepScreenshot(*empty.dialog, QStringLiteral("export-empty"));
}

void ExportDialogTest::beginsWithAGalleryOfEngines()
{
    Scene scene;
    scene.probe.source = "builtin:axes";
    ShownDialog shown(scene);
    QVERIFY(shown.isReady);
    QVERIFY(shown.dialog->engine() != nullptr); // nothing has to be listed first
    QVERIFY(shown.find<QPushButton>("export.start")->isEnabled());
    auto* gallery = shown.find<QListWidget>("export.gallery");
    QCOMPARE(gallery->count(), static_cast<int>(engineProfiles().size()) + 1);
    for (int row = 0; row < gallery->count() - 1; ++row) {
        gallery->setCurrentRow(row);
        const EngineProfile& profile = engineProfiles()[static_cast<size_t>(row)];
        QCOMPARE(shown.dialog->engine()->word, profile.word);
        QVERIFY(QTest::qWaitFor([&] { return shown.dialog->isEstimated(); }, patience));
        QCOMPARE(shown.find<QTreeWidget>("engine.files")->topLevelItemCount(), static_cast<int>(profile.files.size()) + 1);
        QCOMPARE(shown.find<QLabel>("engine.proven")->text().contains(QStringLiteral("not proven")), profile.proven.empty());
        QVERIFY(shown.dialog->command().contains(QString::fromStdString("--for " + std::string(profile.word))));
    }
    shown.dialog->chooseEngine(QStringLiteral("filament"));
    QVERIFY(QTest::qWaitFor([&] { return shown.dialog->isEstimated(); }, patience));
    keepScreenshot(*shown.dialog, QStringLiteral("export-engine"));
    gallery->setCurrentRow(gallery->count() - 1);
    QVERIFY(shown.dialog->engine() == nullptr);
}

void ExportDialogTest::anEnginesFilesAreTheCommandLines()
{
    Scene scene;
    scene.probe.source = "builtin:axes";
    scene.probe.yawDeg = 30.0;
    scene.probe.exposure = 1.0;
    ShownDialog shown(scene);
    QVERIFY(shown.isReady);
    shown.workspace.document.save(QString::fromStdString((shown.folder / "scene.mirrorball").string()));
    shown.dialog->chooseEngine(QStringLiteral("filament"));
    shown.choose("engine.size", 1); // 64
    QVERIFY(shown.dialog->command().contains(QStringLiteral("--size 64")));
    const QStringList files = shown.exports();
    QCOMPARE(files.size(), 5);
    shown.dialog->setFolder(QString::fromStdString((shown.folder / "again" / "out").string()));
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PATH"),
                       QFileInfo(QStringLiteral(MIRRORBALL_PROGRAM)).absolutePath() + u':' + environment.value(QStringLiteral("PATH")));
    shell.setProcessEnvironment(environment);
    shell.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), shown.dialog->command()});
    QVERIFY(shell.waitForFinished(patience));
    QCOMPARE(shell.exitCode(), 0);
    for (const QString& file : files) {
        const std::string name = QFileInfo(file).fileName().toStdString();
        const std::string here = readBytes(shown.folder / "out" / name), there = readBytes(shown.folder / "again" / "out" / name);
        QVERIFY2(!here.empty() && here == there, name.c_str());
    }
}

void ExportDialogTest::offersThePaintedMapWhereThereIsOne()
{
    ShownDialog shown;
    QVERIFY(shown.isReady);
    QAction* painted = shown.find<QPushButton>("export.add")->menu()->actions().last();
    QVERIFY(!painted->isEnabled());
    shown.workspace.document.edit({}, {}, [](Scene& scene) { scene.material.sphereMap.source = "jade"; });
    QVERIFY(painted->isEnabled());
    painted->trigger();
    QCOMPARE(shown.target(3).kind, ExportKind::Painted);
    QCOMPARE(QString::fromStdString(shown.target(3).fileName()), QStringLiteral("matcap.png"));
    QCOMPARE(shown.target(3).size, 512);
    QVERIFY(!shown.target(3).mips);
    for (const char* name : {"export.parameterization", "export.faces", "export.levels", "export.level-files"})
        QVERIFY2(!shown.find<QWidget>(name)->isVisible(), name);
    for (const char* name : {"export.size", "export.border", "export.format", "export.mips", "export.file"})
        QVERIFY2(shown.find<QWidget>(name)->isVisible(), name);
    QVERIFY(shown.find<QComboBox>("export.format")->currentText() == QStringLiteral("PNG, 8 bit"));
    QTRY_VERIFY(shown.dialog->isEstimated());
    QVERIFY2(shown.dialog->estimateText().contains(QStringLiteral("13 files")), qPrintable(shown.dialog->estimateText()));
    keepScreenshot(*shown.dialog, QStringLiteral("export-painted"));
    // Without the map, what is wrong is told when it is looked at.
    shown.workspace.document.edit({}, {}, [](Scene& scene) { scene.material.sphereMap = {}; });
    QTRY_VERIFY2(shown.dialog->statusText().contains(QStringLiteral("exports[3].kind")), qPrintable(shown.dialog->statusText()));
    keepScreenshot(*shown.dialog, QStringLiteral("export-painted-gone"));
}

void ExportDialogTest::writesThePaintedMapAsPaintDoes()
{
    Scene scene;
    scene.material.sphereMap.source = "silhouette"; // whose levels are painted by hand
    scene.material.sphereMap.size = 128;
    ShownDialog shown(scene);
    QVERIFY(shown.isReady);
    shown.dialog->chooseEngine({}); // its own list
    shown.find<QPushButton>("export.add")->menu()->actions().last()->trigger();
    QVERIFY(shown.target(0).mips);
    QCOMPARE(QString::fromStdString(shown.target(0).fileName()), QStringLiteral("matcap.exr"));
    QVERIFY(!shown.find<QSpinBox>("export.border")->isVisible());
    QVERIFY(shown.find<QCheckBox>("export.level-files")->isVisible());
    QTRY_VERIFY(shown.dialog->isEstimated());
    keepScreenshot(*shown.dialog, QStringLiteral("export-painted-levels"));
    const auto isWhatPaintWrites = [&](const QStringList& options, const QString& painted, const std::string& first,
                                       const std::string& exported) {
        QProcess paint;
        paint.start(QStringLiteral(MIRRORBALL_PROGRAM),
                    QStringList{QStringLiteral("paint"), QStringLiteral("silhouette"), QStringLiteral("--size"), QStringLiteral("128"),
                                QStringLiteral("-o"), QString::fromStdString((shown.folder / painted.toStdString()).string())} +
                        options);
        const std::string bytes = paint.waitForFinished(patience) ? readBytes(shown.folder / first) : std::string();
        return !bytes.empty() && bytes == readBytes(shown.folder / "out" / exported);
    };
    QCOMPARE(shown.exports().size(), 2);
    QVERIFY(isWhatPaintWrites({QStringLiteral("--levels")}, QStringLiteral("chain.exr"), "chain.exr", "matcap.exr"));

    QTest::mouseClick(shown.find<QCheckBox>("export.level-files"), Qt::LeftButton, {},
                      QPoint(8, shown.find<QCheckBox>("export.level-files")->height() / 2));
    QCOMPARE(QString::fromStdString(shown.target(0).file), QStringLiteral("matcap_%d.exr"));
    QCOMPARE(shown.exports().size(), 9);
    QVERIFY(isWhatPaintWrites({QStringLiteral("--levels")}, QStringLiteral("l_%d.exr"), "l_3.exr", "matcap_3.exr"));

    QTest::mouseClick(shown.find<QCheckBox>("export.mips"), Qt::LeftButton, {},
                      QPoint(8, shown.find<QCheckBox>("export.mips")->height() / 2));
    QCOMPARE(QString::fromStdString(shown.target(0).fileName()), QStringLiteral("matcap.exr"));
    shown.find<QSpinBox>("export.border")->setValue(2);
    shown.choose("export.format", 5);
    QCOMPARE(QString::fromStdString(shown.target(0).fileName()), QStringLiteral("matcap.png"));
    QCOMPARE(shown.exports().size(), 2);
    QVERIFY(isWhatPaintWrites({QStringLiteral("--border"), QStringLiteral("2")}, QStringLiteral("m.png"), "m.png", "matcap.png"));
    QVERIFY(shown.find<QCheckBox>("export.mips")->isEnabled()); // numbered pictures
}

void ExportDialogTest::keepsWhatEachKindUnderstands()
{
    ExportTarget target{.name = "m", .kind = ExportKind::Specular, .size = 16384, .file = "m_%s.exr", .mips = true};
    target = withKind(target, ExportKind::Painted);
    QCOMPARE(target.size, 8192);
    QCOMPARE(QString::fromStdString(target.fileName()), QStringLiteral("m.exr"));
    QVERIFY(target.mips);
    target = withMips(target, Mips::None);
    target.border = 2;
    QCOMPARE(withMips(target, Mips::All).border, 0);
    QCOMPARE(withKind(target, ExportKind::Diffuse).border, 0);
    const ExportTarget pictures = withMips(withFormat(target, exportFormats()[5]), Mips::All);
    QVERIFY(pictures.mips);
    QVERIFY(!withKind(pictures, ExportKind::Source).mips); // a map of the probe has no numbered files unless its name says so
    const ExportTarget numbered = withLevelFiles(pictures, LevelFiles::Each);
    QCOMPARE(QString::fromStdString(numbered.fileName()), QStringLiteral("m_%d.png"));
    QVERIFY(withKind(numbered, ExportKind::Source).mips);
    QVERIFY(withLevelFiles(numbered, LevelFiles::One) == pictures);
    QCOMPARE(QString::fromStdString(withMips(numbered, Mips::None).fileName()), QStringLiteral("m.png"));
    for (const ExportKind kind : {ExportKind::Source, ExportKind::Specular, ExportKind::Diffuse, ExportKind::Chain, ExportKind::Painted}) {
        Scene scene;
        scene.material.sphereMap.source = "jade";
        scene.exports = {withKind(numbered, kind), withKind(target, kind), newTarget(scene, kind)};
        scene.exports[1].name = "other";
        scene.exports[1].file = "other.exr";
        validate(scene); // throws where something is left that the kind does not take
    }
}

void ExportDialogTest::namesAllControls()
{
    ShownDialog shown;
    const QStringList names = unexplained(*shown.dialog);
    QVERIFY2(names.isEmpty(), qPrintable(names.join(u'\n')));
}

} // namespace mirrorball::test
