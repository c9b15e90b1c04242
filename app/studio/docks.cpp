#include "docks.h"

#include "widgets/controls/color_picker.h"
#include "widgets/panels/lobe_error_panel.h"
#include "widgets/panels/map_panel.h"
#include "widgets/panels/material_panel.h"
#include "widgets/panels/plan_view.h"
#include "widgets/panels/probes_panel.h"
#include "widgets/panels/report_panel.h"
#include "widgets/panels/snapshots_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/spheremap/sphere_map_panel.h"

namespace mirrorball::studio {

namespace {

template <typename Panel>
QWidget* make(Workspace& workspace)
{
    return new Panel(workspace);
}

} // namespace

const std::vector<DockEntry>& dockEntries()
{
    static const std::vector<DockEntry> entries{
        {"probes", QT_TRANSLATE_NOOP("Docks", "Probes"), "probes", "files.md", Qt::LeftDockWidgetArea, make<ProbesPanel>},
        {"material", QT_TRANSLATE_NOOP("Docks", "Material"), "material", "blur.md", Qt::RightDockWidgetArea, make<MaterialPanel>},
        {"view", QT_TRANSLATE_NOOP("Docks", "View"), "view", "studio.md", Qt::RightDockWidgetArea, make<ViewPanel>},
        {"map", QT_TRANSLATE_NOOP("Docks", "Map"), "map", "parameterizations.md", Qt::LeftDockWidgetArea, make<MapPanel>},
        {"sphere-map", QT_TRANSLATE_NOOP("Docks", "Sphere map"), "sphere-map", "sphere-maps.md", Qt::RightDockWidgetArea,
         make<SphereMapPanel>},
        {"color", QT_TRANSLATE_NOOP("Docks", "Color"), "eyedropper", "studio.md", Qt::LeftDockWidgetArea,
         [](Workspace&) -> QWidget* { return new ColorPicker; }},
        {"plan", QT_TRANSLATE_NOOP("Docks", "Plan"), "plan", "blur.md", Qt::BottomDockWidgetArea, make<PlanView>},
        {"report", QT_TRANSLATE_NOOP("Docks", "Report"), "report", "reports.md", Qt::BottomDockWidgetArea, make<ReportPanel>},
        {"lobe-error", QT_TRANSLATE_NOOP("Docks", "Lobe error"), "lobe-error", "materials.md", Qt::BottomDockWidgetArea,
         make<LobeErrorPanel>},
        {"snapshots", QT_TRANSLATE_NOOP("Docks", "Snapshots"), "snapshot", "comparing.md", Qt::LeftDockWidgetArea, make<SnapshotsPanel>},
    };
    return entries;
}

const std::vector<DockTabs>& dockTabs()
{
    static const std::vector<DockTabs> tabs{{"material", "view"}, {"material", "sphere-map"}, {"map", "color"},
                                            {"map", "snapshots"}, {"plan", "lobe-error"},     {"plan", "report"}};
    return tabs;
}

} // namespace mirrorball::studio
