#include "painted_export_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "support/temporary_folder.h"
#include "widgets/controls/text.h"
#include "widgets/exports/painted_export.h"

#include "core/image/map_file.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PaintedExportTest> registered;

namespace {

/// Chooses the menu's entry and answers the file dialog as a user does.
void exportAs(SphereMapPanel& panel, const QString& filter, const std::filesystem::path& path)
{
    QAction* found = nullptr;
    for (QAction* action : panel.findChildren<QAction*>())
        if (action->text() == QStringLiteral("Export the picture..."))
            found = action;
    QVERIFY(found);
    QTimer::singleShot(200, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        for (const QString& offered : dialog->nameFilters())
            if (offered.startsWith(filter))
                dialog->selectNameFilter(offered);
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(fromPath(path));
        QTest::keyClick(name, Qt::Key_Return);
    });
    found->trigger();
}

} // namespace

void PaintedExportTest::init() { QSettings().clear(); }

void PaintedExportTest::writesThePictureThatTheMenuIsAskedFor()
{
    const TemporaryFolder folder;
    Painting painting;
    painting.drag(painting.at(-0.5, 0.0), painting.at(0.5, 0.2));
    painting.document().edit({}, {}, [](Scene& scene) { scene.material.sphereMap.size = 64; });
    auto* exporter = painting.panel().findChild<PaintedExport*>();
    QSignalSpy written(exporter, &PaintedExport::written);
    exportAs(painting.panel(), QStringLiteral("PNG"), folder / "ball.png");
    exportAs(painting.panel(), QStringLiteral("OpenEXR with all"), folder / "chain.exr");
    QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, 30000);
    const SphereMapDocument& map = *painting.editor().map();
    writePictures(folder / "same.png", paintedPictures(map, {.size = 64}), paintedFileOptions(map, SampleType::Float));
    QVERIFY(readBytes(folder / "ball.png") == readBytes(folder / "same.png"));
    QCOMPARE(openImage(folder / "chain.exr")->info().levels, 7);
}

void PaintedExportTest::tellsWhatIsWrongByANotice()
{
    const TemporaryFolder folder;
    Painting painting;
    auto* exporter = painting.panel().findChild<PaintedExport*>();
    QSignalSpy written(exporter, &PaintedExport::written);
    exporter->write(fromPath(folder / "no such folder" / "ball.png"), PaintedLevels::One);
    const Notices& notices = painting.window()->workspace().notices;
    QTRY_VERIFY_WITH_TIMEOUT(!notices.all().isEmpty(), 30000);
    QVERIFY2(notices.all().front().text.contains(QStringLiteral("ball.png")), qPrintable(notices.all().front().text));
    exporter->write(fromPath(folder / "ball.png"), PaintedLevels::One);
    QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, 30000);
    QVERIFY(notices.all().isEmpty());
}

} // namespace mirrorball::test
