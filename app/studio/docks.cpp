#include "docks.h"

#include <QLabel>

namespace mirrorball::studio {

namespace {

QWidget* placeholder(Workspace&)
{
    return new QLabel;
}

} // namespace

const std::vector<DockEntry>& dockEntries()
{
    static const std::vector<DockEntry> entries{
        {"probes", QT_TRANSLATE_NOOP("Docks", "Probes"), "probes", Qt::LeftDockWidgetArea, placeholder},
        {"material", QT_TRANSLATE_NOOP("Docks", "Material"), "material", Qt::RightDockWidgetArea, placeholder},
        {"map", QT_TRANSLATE_NOOP("Docks", "Map"), "map", Qt::LeftDockWidgetArea, placeholder},
        {"plan", QT_TRANSLATE_NOOP("Docks", "Plan"), "plan", Qt::RightDockWidgetArea, placeholder},
    };
    return entries;
}

} // namespace mirrorball::studio
