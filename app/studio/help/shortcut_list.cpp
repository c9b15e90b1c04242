#include "shortcut_list.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSet>

namespace mirrorball::studio {

namespace {

QString plain(QString text)
{
    text.remove(u'&');
    if (text.endsWith(u'…'))
        text.chop(1);
    return text;
}

QString keysOf(const QAction& action)
{
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts())
        keys << key.toString(QKeySequence::NativeText);
    return keys.join(QStringLiteral(", "));
}

class List {
public:
    void addMenu(const QMenu& menu, const QString& path)
    {
        for (const QAction* action : menu.actions()) {
            if (action->menu())
                addMenu(*action->menu(), path + QStringLiteral(": ") + plain(action->text()));
            else
                add(*action, path);
        }
    }
    void add(const QAction& action, const QString& where)
    {
        if (action.shortcut().isEmpty() || m_seen.contains(&action))
            return;
        m_seen.insert(&action);
        m_shortcuts.push_back({where, plain(action.text()), keysOf(action)});
    }
    void add(const QAbstractButton& button, const QString& where)
    {
        if (!button.shortcut().isEmpty() && !button.text().contains(u'&'))
            m_shortcuts.push_back({where, button.accessibleName(), button.shortcut().toString(QKeySequence::NativeText)});
    }
    QVector<Shortcut> take() { return std::move(m_shortcuts); }

private:
    QVector<Shortcut> m_shortcuts;
    QSet<const QAction*> m_seen;
};

/// The dock that a widget stands in, or its own name.
QString placeOf(const QWidget* widget)
{
    for (const QWidget* at = widget; at; at = at->parentWidget())
        if (const auto* dock = qobject_cast<const QDockWidget*>(at))
            return dock->windowTitle();
    return widget->accessibleName();
}

} // namespace

QVector<Shortcut> shortcutsOf(const QMainWindow& window)
{
    List list;
    for (const QAction* menu : window.menuBar()->actions())
        if (menu->menu())
            list.addMenu(*menu->menu(), plain(menu->text()));
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        for (const QAction* action : widget->actions())
            if (!qobject_cast<const QMenu*>(widget) && !qobject_cast<const QMenuBar*>(widget))
                list.add(*action, placeOf(widget));
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            list.add(*button, placeOf(widget));
    }
    return list.take();
}

QString shortcutsHtml(const QMainWindow& window)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("ShortcutList", text); };
    QString html = QStringLiteral("<h1>%1</h1>").arg(tr(QT_TRANSLATE_NOOP("ShortcutList", "Keyboard shortcuts")));
    QString where;
    for (const Shortcut& shortcut : shortcutsOf(window)) {
        if (shortcut.where != where)
            html += QStringLiteral("%1<h3>%2</h3><table cellspacing='0' cellpadding='3'>")
                        .arg(where.isEmpty() ? QString() : QStringLiteral("</table>"), shortcut.where.toHtmlEscaped());
        where = shortcut.where;
        html += QStringLiteral("<tr><td width='220'><b>%1</b></td><td>%2</td></tr>")
                    .arg(shortcut.keys.toHtmlEscaped(), shortcut.what.toHtmlEscaped());
    }
    return html + QStringLiteral("</table><p>%1</p>")
                      .arg(tr(QT_TRANSLATE_NOOP("ShortcutList", "Docks and the picture have keys and mouse gestures of their own: "
                                                                "F1 in one of them opens the page that names them.")));
}

} // namespace mirrorball::studio
