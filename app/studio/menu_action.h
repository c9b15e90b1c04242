#pragma once

#include <QAction>
#include <QIcon>
#include <QMenu>

namespace mirrorball::studio {

/// A command of a menu: named by its id, with its key, and its help as tooltip and in the status bar.
/// @param slot  a member of the receiver, or something to call
template <typename Receiver, typename Slot>
QAction* addCommand(QMenu& menu, const char* id, const QIcon& picture, const QString& text, const QString& help, const QKeySequence& key,
                    Receiver* receiver, Slot slot)
{
    QAction* action = menu.addAction(picture, text, receiver, slot);
    action->setObjectName(QLatin1String(id));
    action->setShortcut(key);
    action->setToolTip(help);
    action->setStatusTip(help);
    return action;
}

} // namespace mirrorball::studio
