#include "report_panel_test.h"

#include "patience.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "support/temporary_folder.h"
#include "widgets/panels/report_panel.h"

#include <functional>
#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ReportPanelTest> registered;

namespace {

/// A probe and a map so small that every method is measured in a second or two.
Scene glossyScene(const TemporaryFolder& folder)
{
    writeImage(folder / "room.exr", renderBuiltinProbe("cube-room", {Parameterization::Latlong, 32, 0}).image);
    Scene scene;
    scene.probe.source = (folder / "room.exr").string();
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    scene.map.size = 16;
    return scene;
}

struct ShownPanel {
    explicit ShownPanel(const std::function<void(Scene&)>& change = {})
    {
        Scene scene = glossyScene(folder);
        if (change)
            change(scene);
        workspace.document.reset(scene);
        panel = std::make_unique<ReportPanel>(workspace);
        panel->resize(460, 640);
        panel->show();
        isReady = QTest::qWaitForWindowExposed(panel.get());
    }
    bool settle()
    {
        return QTest::qWaitFor([&] { return workspace.live.isUpToDate() && !panel->isMeasuring() && panel->statusText() != tr; }, patience);
    }
    int indexOf(Method method) const
    {
        const auto& points = panel->points();
        for (size_t i = 0; i < points.size(); ++i)
            if (points[i].setting.method == method && points[i].state == MeasurementState::Measured)
                return static_cast<int>(i);
        return -1;
    }

    TemporaryFolder folder;
    const QString tr = QStringLiteral("Methods are measured once the material has come to rest.");
    Workspace workspace;
    std::unique_ptr<ReportPanel> panel;
    bool isReady = false;
};

} // namespace

void ReportPanelTest::measuresEveryMethodOfTheMaterial()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    for (const Method method : {Method::Reference, Method::Auto, Method::Spectral, Method::Direct, Method::Importance, Method::Mip})
        QVERIFY2(shown.indexOf(method) >= 0, std::string(name(method)).c_str());
    const RacePoint& spectral = shown.panel->points()[static_cast<size_t>(shown.indexOf(Method::Spectral))];
    QVERIFY(spectral.seconds > 0.0);
    QVERIFY(spectral.error.relRms < 0.05);
    QCOMPARE(shown.panel->findChild<QTreeWidget*>(QStringLiteral("report.table"))->topLevelItemCount(),
             static_cast<int>(shown.panel->points().size()));
    keepScreenshot(*shown.panel, QStringLiteral("report"));
    shown.panel->resize(820, 220);
    keepScreenshot(*shown.panel, QStringLiteral("report-wide"));
}

void ReportPanelTest::aClickOnAPointChoosesTheMethod()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    const int index = shown.indexOf(Method::Importance);
    const auto at = shown.panel->chart().positionOf(index);
    QVERIFY(at.has_value());
    QTest::mouseClick(shown.panel->chart().viewport(), Qt::LeftButton, {}, at->toPoint());
    QVERIFY(shown.panel->picked() >= 0);
    const MethodSetting& picked = shown.panel->points()[static_cast<size_t>(shown.panel->picked())].setting;
    QCOMPARE(shown.workspace.document.scene().filter.method, picked.method);
    QTRY_VERIFY_WITH_TIMEOUT(shown.workspace.methodError.map() != nullptr, patience); // what the Map dock shows
    QVERIFY(shown.workspace.methodError.description().contains(QString::fromStdString(std::string(name(picked.method)))));
    keepScreenshot(*shown.panel, QStringLiteral("report-picked"));
    shown.workspace.document.undoStack().undo();
    QCOMPARE(shown.workspace.document.scene().filter.method, Method::Auto);
}

void ReportPanelTest::keysChooseInTheTable()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    auto* table = shown.panel->findChild<QTreeWidget*>(QStringLiteral("report.table"));
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Home);
    QTest::keyClick(table, Qt::Key_Down);
    QVERIFY(shown.panel->picked() >= 0);
    QCOMPARE(table->currentItem()->data(0, Qt::UserRole).toInt(), shown.panel->picked());
}

void ReportPanelTest::measuresAgainWhenTheLobeChangesAndOnlyThen()
{
    ShownPanel shown;
    QVERIFY(shown.isReady && shown.settle());
    shown.workspace.document.edit(QStringLiteral("weight"), {}, [](Scene& s) { s.material.specular.weight = 0.5; });
    QTest::qWait(200);
    QVERIFY(!shown.panel->isMeasuring());
    shown.workspace.document.edit(QStringLiteral("exponent"), {}, [](Scene& s) { s.material.specular.exponent = 40.0; });
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->isMeasuring(), patience);
    QVERIFY(shown.settle());
    QVERIFY2(shown.panel->statusText().contains(QStringLiteral("phong:40")), qPrintable(shown.panel->statusText()));
}

void ReportPanelTest::givesWayToADragAndGoesOnAfterIt()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->statusText().contains(QStringLiteral("for all settings")), patience); // how long it will take
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->points().size() >= 2, patience);
    const size_t before = shown.panel->points().size();
    shown.workspace.document.edit(QStringLiteral("orbit"), QStringLiteral("orbit"), [](Scene& s) { s.view.camera.yawDeg += 1.0; });
    QTest::qWait(400);
    QVERIFY(shown.panel->points().size() <= before + 1); // at most the one that was done already
    QVERIFY(shown.panel->isMeasuring());
    shown.workspace.document.finishEdit();
    QVERIFY(shown.settle());
    QVERIFY(shown.panel->points().size() > before + 1);
}

void ReportPanelTest::saysThatAMirrorIsNotFiltered()
{
    ShownPanel shown([](Scene& scene) { scene.material.specular = {}; });
    QVERIFY(shown.isReady && shown.settle());
    QVERIFY(shown.panel->points().empty());
    QVERIFY2(shown.panel->statusText().contains(QStringLiteral("mirror")), qPrintable(shown.panel->statusText()));
    keepScreenshot(*shown.panel, QStringLiteral("report-mirror"));
}

void ReportPanelTest::stopsWhenAsked()
{
    ShownPanel shown;
    QVERIFY(shown.isReady);
    QTRY_VERIFY_WITH_TIMEOUT(shown.panel->isMeasuring(), patience);
    shown.panel->findChild<QPushButton*>(QStringLiteral("report.stop"))->click();
    QVERIFY(!shown.panel->isMeasuring());
    QVERIFY(shown.panel->statusText().startsWith(QStringLiteral("Stopped")));
}

void ReportPanelTest::namesAllControls()
{
    ShownPanel shown;
    const QStringList names = unexplained(*shown.panel);
    QVERIFY2(names.isEmpty(), qPrintable(names.join(u'\n')));
}

} // namespace mirrorball::test
