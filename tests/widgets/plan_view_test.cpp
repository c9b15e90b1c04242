#include "plan_view_test.h"

#include "widgets/panels/plan_view.h"

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PlanViewTest> registered;

static const PlanRow* rowNamed(const std::vector<PlanRow>& rows, const char* name)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const PlanRow& row) { return row.name == QLatin1String(name); });
    return found == rows.end() ? nullptr : &*found;
}

static Scene glossy()
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 40};
    return scene;
}

void PlanViewTest::showsWhatIsLeftOutAndHowLongTheRestTook()
{
    LiveMaps maps;
    const MadeScene made = maps.update(glossy(), {});
    const std::vector<PlanRow> rows = planRows(made, 0.012);
    QCOMPARE(rows.size(), made.plan.decisions.size());
    const PlanRow* diffuse = rowNamed(rows, "Irradiance map");
    QVERIFY(diffuse && diffuse->isLeftOut && diffuse->why == QStringLiteral("diffuse weight is 0"));
    for (const char* done : {"Compute probe", "Spectrum", "Filter specular map"}) {
        const PlanRow* row = rowNamed(rows, done);
        QVERIFY2(row && !row->isLeftOut && row->seconds > 0.0, done);
    }
    QCOMPARE(rowNamed(rows, "Draw")->seconds, 0.012);
}

void PlanViewTest::saysWhatWasKept()
{
    LiveMaps maps;
    Scene scene = glossy();
    maps.update(scene, {});
    scene.material.specular.weight = 0.5; // no map depends on it
    const std::vector<PlanRow> rows = planRows(maps.update(scene, {}), -1.0);
    QVERIFY(rowNamed(rows, "Filter specular map")->isKept);
    QVERIFY(rowNamed(rows, "Compute probe")->isKept);
    scene.material.specular.exponent = 41;
    const std::vector<PlanRow> refiltered = planRows(maps.update(scene, {}), -1.0);
    QVERIFY(!rowNamed(refiltered, "Filter specular map")->isKept);
    QVERIFY(rowNamed(refiltered, "Compute probe")->isKept);
    QVERIFY(rowNamed(refiltered, "Spectrum")->isKept);
}

void PlanViewTest::followsTheDocument()
{
    Workspace workspace;
    PlanView view(workspace);
    view.show();
    auto* stages = view.findChild<QTreeWidget*>();
    const auto timeOf = [&](const QString& name) {
        for (int i = 0; i < stages->topLevelItemCount(); ++i)
            if (stages->topLevelItem(i)->text(0) == name)
                return stages->topLevelItem(i)->text(1);
        return QString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(timeOf(QStringLiteral("Filter specular map")), QStringLiteral("left out"), 60000);
    workspace.document.edit(QStringLiteral("glossy"), {}, [](Scene& scene) { scene.material = glossy().material; });
    QTRY_VERIFY_WITH_TIMEOUT(timeOf(QStringLiteral("Filter specular map")).endsWith(QStringLiteral("ms")), 60000);
}

} // namespace mirrorball::test
