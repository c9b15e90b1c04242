#include "command_keys.h"

#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include <algorithm>

namespace mirrorball::studio {

namespace {

QString settingOf(const QAction& action) { return QStringLiteral("keys/") + action.objectName(); }

void addCommands(const QMenu& menu, const QString& where, QVector<Command>& commands)
{
    for (QAction* action : menu.actions()) {
        QString text = action->text();
        text.remove(u'&');
        if (action->menu())
            addCommands(*action->menu(), where + QStringLiteral(": ") + text, commands);
        else if (!action->objectName().isEmpty() && !action->isSeparator())
            commands.push_back({action, where});
    }
}

} // namespace

bool isPlainKey(const QKeySequence& key)
{
    return key.count() == 1 && !(key[0].keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) &&
           key[0].key() < Qt::Key_Escape; // what has no letter comes after
}

CommandKeys::CommandKeys(QMainWindow& window, QWidget& picture) : QObject(&window), m_picture(picture)
{
    for (const QAction* menu : window.menuBar()->actions())
        if (menu->menu())
            addCommands(*menu->menu(), menu->text().remove(u'&'), m_commands);
    const QSettings settings;
    for (const Command& command : m_commands) {
        m_first[command.action] = command.action->shortcuts();
        const QVariant chosen = settings.value(settingOf(*command.action));
        if (chosen.isValid())
            apply(*command.action, {QKeySequence::fromString(chosen.toString(), QKeySequence::PortableText)});
    }
}

const QAction* CommandKeys::owner(const QKeySequence& key) const
{
    const auto found = std::find_if(m_commands.begin(), m_commands.end(),
                                    [&](const Command& command) { return command.action->shortcuts().contains(key); });
    return found == m_commands.end() ? nullptr : found->action;
}

void CommandKeys::apply(QAction& action, const QList<QKeySequence>& keys)
{
    QList<QKeySequence> used = keys;
    used.removeAll(QKeySequence());
    const bool isPlain = std::any_of(used.begin(), used.end(), isPlainKey);
    action.setShortcutContext(isPlain ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
    if (isPlain)
        m_picture.addAction(&action);
    action.setShortcuts(used);
    const QString help = action.statusTip();
    if (!help.isEmpty())
        action.setToolTip(used.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, used.front().toString(QKeySequence::NativeText)));
}

void CommandKeys::set(QAction& action, const QKeySequence& key)
{
    QSettings().setValue(settingOf(action), key.toString(QKeySequence::PortableText));
    apply(action, {key});
}

void CommandKeys::reset(QAction& action)
{
    QSettings().remove(settingOf(action));
    apply(action, m_first.value(&action));
}

void CommandKeys::resetAll()
{
    for (const Command& command : m_commands)
        reset(*command.action);
}

} // namespace mirrorball::studio
