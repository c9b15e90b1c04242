#include "lobe_error_panel_test.h"

#include "patience.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "support/temporary_folder.h"
#include "widgets/panels/lobe_error_panel.h"

#include <QClipboard>
#include <QGuiApplication>

#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<LobeErrorPanelTest> registered;

namespace {

struct ShownPanel {
    explicit ShownPanel(const std::string& model)
    {
        writeImage(folder / "room.exr", renderBuiltinProbe("cube-room", {Parameterization::Latlong, 32, 0}).image);
        Scene scene;
        scene.probe.source = (folder / "room.exr").string();
        scene.material.brdf.model = model;
        scene.map.size = 16;
        workspace.document.reset(scene);
        panel = std::make_unique<LobeErrorPanel>(workspace);
        panel->resize(720, 300);
        panel->show();
        isReady = QTest::qWaitForWindowExposed(panel.get());
    }
    bool settle()
    {
        return QTest::qWaitFor([&] { return workspace.live.isUpToDate() && !panel->isMeasuring(); }, patience);
    }

    TemporaryFolder folder;
    Workspace workspace;
    std::unique_ptr<LobeErrorPanel> panel;
    bool isReady = false;
};

} // namespace

void LobeErrorPanelTest::drawsALineForEachChoiceOfLookups()
{
    ShownPanel shown("ggx:roughness=0.6");
    QVERIFY(shown.isReady && shown.settle());
    QVERIFY(shown.panel->errors());
    const BrdfErrors& errors = *shown.panel->errors();
    QCOMPARE(errors.choices.size(), size_t(5));
    const auto* chart = shown.panel->findChild<QChartView*>(QStringLiteral("lobe_error.chart"));
    QCOMPARE(chart->chart()->series().size(), 5);
    QCOMPARE(shown.panel->findChild<QTreeWidget*>(QStringLiteral("lobe_error.table"))->topLevelItemCount(), 5);
    const size_t last = errors.viewsDeg.size() - 1;
    QVERIFY(errors.relRms[0][last] < 0.5 * errors.relRms[2][last]); // five lookups against the split sum
    keepScreenshot(*shown.panel, QStringLiteral("lobe-error"));

    shown.panel->findChild<QPushButton*>(QStringLiteral("lobe_error.copy"))->click(); // the command that measures the same
    const QString command = QGuiApplication::clipboard()->text();
    QVERIFY2(command.startsWith(QStringLiteral("mirrorball brdf ggx:roughness=0.6 --errors ")), qPrintable(command));
    QVERIFY2(command.endsWith(QStringLiteral("--lookups lookups:5,lookups:3,split-sum,three,filament")), qPrintable(command));
}

void LobeErrorPanelTest::saysThatARoundLobeHasNoCurve()
{
    ShownPanel shown("");
    QVERIFY(shown.isReady && shown.settle());
    QTRY_VERIFY(shown.panel->statusText().contains(QStringLiteral("no BRDF")));
    QVERIFY(!shown.panel->errors());
}

void LobeErrorPanelTest::measuresAnewWhenTheMaterialChanges()
{
    ShownPanel shown("ggx:roughness=0.6");
    QVERIFY(shown.isReady && shown.settle());
    QVERIFY(shown.panel->errors());
    shown.workspace.document.edit(QStringLiteral("rougher"), {}, [](Scene& scene) { scene.material.brdf.model = "ggx:roughness=0.8"; });
    QVERIFY(
        QTest::qWaitFor([&] { return shown.panel->errors() && shown.panel->errors()->model.find("0.64") != std::string::npos; }, patience));
    shown.workspace.document.edit(QStringLiteral("round"), {}, [](Scene& scene) { scene.material.brdf.model.clear(); });
    QVERIFY(QTest::qWaitFor([&] { return !shown.panel->errors(); }, patience));
}

} // namespace mirrorball::test
