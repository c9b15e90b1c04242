#pragma once

#include <QMainWindow>
#include <QString>
#include <QVector>

namespace mirrorball::studio {

/// A command, or a control, that keys reach.
struct Shortcut {
    QString where; ///< the menu or the dock that has it
    QString what;
    QString keys; ///< as this platform writes them
};

/// All shortcuts of a window, by its actions: those of the menus in their order, then those of the widgets inside.
QVector<Shortcut> shortcutsOf(const QMainWindow& window);
/// The same as a page.
QString shortcutsHtml(const QMainWindow& window);

} // namespace mirrorball::studio
