#include "docks.h"

#include "widgets/material_panel.h"
#include "widgets/plan_view.h"
#include "widgets/view_panel.h"

#include <QLabel>

namespace mirrorball::studio {

namespace {

template <typename Panel>
QWidget* make(Workspace& workspace)
{
    return new Panel(workspace);
}

QWidget* placeholder(Workspace&)
{
    return new QLabel;
}

} // namespace

const std::vector<DockEntry>& dockEntries()
{
    static const std::vector<DockEntry> entries{
        {"probes", QT_TRANSLATE_NOOP("Docks", "Probes"), "probes", Qt::LeftDockWidgetArea, placeholder},
        {"material", QT_TRANSLATE_NOOP("Docks", "Material"), "material", Qt::RightDockWidgetArea, make<MaterialPanel>},
        {"view", QT_TRANSLATE_NOOP("Docks", "View"), "view", Qt::RightDockWidgetArea, make<ViewPanel>},
        {"map", QT_TRANSLATE_NOOP("Docks", "Map"), "map", Qt::LeftDockWidgetArea, placeholder},
        {"plan", QT_TRANSLATE_NOOP("Docks", "Plan"), "plan", Qt::BottomDockWidgetArea, make<PlanView>},
    };
    return entries;
}

const std::vector<DockTabs>& dockTabs()
{
    static const std::vector<DockTabs> tabs{{"material", "view"}};
    return tabs;
}

} // namespace mirrorball::studio
