#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QMainWindow>
#include <QObject>
#include <QVector>

namespace mirrorball::studio {

/// A command of the menus, and the menus that lead to it.
struct Command {
    QAction* action;
    QString where;
};

/// Whether a key is one that is typed in texts, too: letters, digits and signs.
bool isPlainKey(const QKeySequence& key);

/// The keys of a window's commands, as somebody chose them: kept with the settings, by the commands' object names. Plain keys work while
/// the picture has the keys; typed elsewhere they change nothing.
class CommandKeys : public QObject {
    Q_OBJECT

public:
    /// Takes the keys that the commands of the menus have by now as the first ones, and gives them those that were chosen.
    /// @param picture  where plain keys work
    CommandKeys(QMainWindow& window, QWidget& picture);

    const QVector<Command>& commands() const { return m_commands; }
    /// The command that has a key; null where it is free.
    const QAction* owner(const QKeySequence& key) const;
    /// From now on and in the next run. @param key  empty: none
    void set(QAction& action, const QKeySequence& key);
    void reset(QAction& action);
    void resetAll();

private:
    void apply(QAction& action, const QList<QKeySequence>& keys);

    QWidget& m_picture;
    QVector<Command> m_commands{};
    QHash<const QAction*, QList<QKeySequence>> m_first{};
};

} // namespace mirrorball::studio
