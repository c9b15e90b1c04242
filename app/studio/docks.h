#pragma once

#include "widgets/workspace/workspace.h"

#include <QString>
#include <QWidget>

#include <vector>

namespace mirrorball::studio {

/// One dock of the window.
struct DockEntry {
    const char* id;          ///< names the dock in the saved layout; never changes
    const char* title;       ///< source text, translated in the context "Docks"
    const char* icon;        ///< of resources/icons
    const char* page;        ///< of the guide, for F1
    Qt::DockWidgetArea area; ///< where it stands at first
    QWidget* (*make)(Workspace& workspace);
};

/// All docks, in the order of the View menu. A new dock is one line here and a widget that takes the workspace.
const std::vector<DockEntry>& dockEntries();

/// Docks that stand behind one another at first.
struct DockTabs {
    const char* front;
    const char* behind;
};
const std::vector<DockTabs>& dockTabs();

} // namespace mirrorball::studio
