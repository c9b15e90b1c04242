#include "docks.h"

#include "widgets/map_panel.h"
#include "widgets/probes_panel.h"

#include <QLabel>

namespace mirrorball::studio {

namespace {

QWidget* placeholder(Workspace&)
{
    return new QLabel;
}

template <typename Panel>
QWidget* make(Workspace& workspace)
{
    return new Panel(workspace);
}

} // namespace

const std::vector<DockEntry>& dockEntries()
{
    static const std::vector<DockEntry> entries{
        {"probes", QT_TRANSLATE_NOOP("Docks", "Probes"), "probes", Qt::LeftDockWidgetArea, make<ProbesPanel>},
        {"material", QT_TRANSLATE_NOOP("Docks", "Material"), "material", Qt::RightDockWidgetArea, placeholder},
        {"map", QT_TRANSLATE_NOOP("Docks", "Map"), "map", Qt::LeftDockWidgetArea, make<MapPanel>},
        {"plan", QT_TRANSLATE_NOOP("Docks", "Plan"), "plan", Qt::RightDockWidgetArea, placeholder},
    };
    return entries;
}

} // namespace mirrorball::studio
