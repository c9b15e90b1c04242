#include "whole_job_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"

#include <QComboBox>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<WholeJobTest> registered;

template <typename Control>
static Control* control(StudioWindow& window, const char* name)
{
    return window->findChild<Control*>(QLatin1String(name));
}

static void choose(StudioWindow& window, const char* name, const QString& item)
{
    auto* combo = control<QComboBox>(window, name);
    QVERIFY2(combo, name);
    const int index = combo->findText(item, Qt::MatchFixedString);
    QVERIFY2(index >= 0, qPrintable(item));
    combo->setCurrentIndex(index);
    emit combo->activated(index);
}

static void type(StudioWindow& window, const char* name, const QString& text)
{
    auto* number = control<NumberField>(window, name);
    QVERIFY2(number, name);
    number->box()->setFocus();
    number->box()->selectAll();
    QTest::keyClicks(number->box(), text + u'\r');
}

// An artist's way through the studio, by its controls alone; the scene file then gives the same bytes on the command line.
void WholeJobTest::fromADroppedProbeToTheMapsThatTheCommandLineWrites()
{
    QSettings().clear();
    const TemporaryFolder folder;
    const std::filesystem::path probe = folder / "room.hdr";
    writeImage(probe, renderBuiltinProbe("cube-room", {Parameterization::Latlong, 128, 0}).image);
    StudioWindow window;
    window.show();

    QVERIFY(dropFiles(*window, {fromPath(probe)}));
    auto* kind = control<QComboBox>(window, "map.parameterization");
    const int paraboloid = kind->findData(static_cast<int>(Parameterization::Paraboloid));
    kind->setCurrentIndex(paraboloid);
    emit kind->activated(paraboloid);
    choose(window, "material.specular.lobe", QStringLiteral("Phong"));
    type(window, "material.specular.exponent", QStringLiteral("200"));
    choose(window, "material.fresnel.kind", QStringLiteral("Dielectric"));
    type(window, "material.fresnel.index", QStringLiteral("1.5"));
    type(window, "material.diffuse.weight", QStringLiteral("1"));
    choose(window, "material.combine", QStringLiteral("Coat"));
    const Scene& scene = window.document().scene();
    QCOMPARE(scene.map.parameterization, Parameterization::Paraboloid);
    QCOMPARE(scene.material.specular.lobe, SurfaceLobe::Phong);
    QCOMPARE(scene.material.specular.exponent, 200.0);
    QCOMPARE(scene.material.fresnel.kind, FresnelKind::Dielectric);
    QCOMPARE(scene.material.fresnel.index, 1.5);
    QCOMPARE(scene.material.combine, Combine::Coat);
    window.waitForPicture();
    QVERIFY(window->workspace().live.made()->maps.specular->front().layout.kind == Parameterization::Paraboloid);

    ExportDialog dialog(window->workspace(), &*window);
    dialog.setFolder(fromPath(folder / "here"));
    dialog.show();
    dialog.list().add(ExportKind::Specular);
    dialog.list().add(ExportKind::Diffuse);
    QVERIFY(window->files().saveAs(fromPath(folder / "job.mirrorball")));
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    dialog.startExport();
    QTRY_VERIFY_WITH_TIMEOUT(!exported.isEmpty(), patience);
    const QStringList files = exported.front().front().toStringList();
    QVERIFY(files.size() >= 2);

    QProcess program;
    program.start(QStringLiteral(MIRRORBALL_PROGRAM),
                  {QStringLiteral("export"), fromPath(folder / "job.mirrorball"), QStringLiteral("-o"), fromPath(folder / "there")});
    QVERIFY(program.waitForFinished(patience));
    QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "there")) {
        const std::string name = entry.path().filename().string();
        QVERIFY2(readBytes(folder / "here" / name) == readBytes(entry.path()), name.c_str());
        ++compared;
    }
    QCOMPARE(compared, static_cast<int>(files.size()) + 1); // and the manifest that names them

    // Everything that was done can be undone, back to the first scene.
    while (window.document().undoStack().canUndo())
        window.document().undoStack().undo();
    QVERIFY(differing(window.document().scene(), newScene()) == Parts());
}

} // namespace mirrorball::test
