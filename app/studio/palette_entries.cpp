#include "palette_entries.h"

#include "widgets/controls/number_field.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>

namespace mirrorball::studio {

namespace {

/// "Edit: Undo orbit".
QString titleOf(const QAction& action, const QString& menu)
{
    QString text = action.text().remove(u'&');
    if (text.endsWith(u'…'))
        text.chop(1);
    return menu.isEmpty() ? text : menu + QStringLiteral(": ") + text;
}

void collect(const QMenu& menu, const QString& path, QVector<PaletteEntry>& entries)
{
    for (QAction* action : menu.actions()) {
        if (action->menu())
            collect(*action->menu(), path + QStringLiteral(": ") + action->text().remove(u'&'), entries);
        else if (!action->isSeparator() && action->isEnabled() && !action->text().isEmpty())
            entries.push_back({titleOf(*action, path), action->shortcut().toString(QKeySequence::NativeText), action->toolTip(),
                               action->icon(), [action] { action->trigger(); }});
    }
}

/// The tab widget whose page this is, or null.
QTabWidget* tabsOf(const QWidget& page)
{
    const auto* stack = qobject_cast<const QStackedWidget*>(page.parentWidget());
    return stack ? qobject_cast<QTabWidget*>(stack->parentWidget()) : nullptr;
}

/// Whether bringing its dock and its tabs to the front would show a widget.
bool couldShow(const QWidget& widget, const QWidget& panel)
{
    for (const QWidget* at = &widget; at && at != &panel; at = at->parentWidget()) {
        if (QTabWidget* tabs = tabsOf(*at)) {
            if (!tabs->isTabVisible(tabs->indexOf(at)))
                return false;
        } else if (at->isHidden() && at->testAttribute(Qt::WA_WState_ExplicitShowHide)) {
            return false;
        }
    }
    return true;
}

bool isControl(const QWidget& widget)
{
    if (qobject_cast<const NumberField*>(&widget))
        return true;
    const QWidget* holder = widget.parentWidget();
    const bool isPart = qobject_cast<const NumberField*>(holder) || qobject_cast<const QComboBox*>(holder) ||
                        qobject_cast<const QAbstractSpinBox*>(holder) || widget.inherits("QComboBoxPrivateContainer") ||
                        qobject_cast<const QScrollBar*>(&widget) || qobject_cast<const QTabBar*>(holder) ||
                        (holder && holder->inherits("QDockWidget"));
    const bool isOne = qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
                       qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
                       qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget);
    return isOne && !isPart && widget.focusPolicy() != Qt::NoFocus;
}

QString nameOf(QWidget& widget)
{
    if (auto* number = qobject_cast<NumberField*>(&widget))
        return number->box()->accessibleName();
    if (!widget.accessibleName().isEmpty())
        return widget.accessibleName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text().remove(u'&');
    return {};
}

} // namespace

QVector<PaletteEntry> commandEntries(const QMainWindow& window)
{
    QVector<PaletteEntry> entries;
    for (const QAction* menu : window.menuBar()->actions())
        if (menu->menu())
            collect(*menu->menu(), menu->text().remove(u'&'), entries);
    return entries;
}

QVector<PaletteEntry> controlEntries(const QMainWindow& window)
{
    QVector<PaletteEntry> entries;
    QSet<QString> known; // parts of one control may have its name
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        const QWidget* panel = dock->widget();
        for (QWidget* widget : panel->findChildren<QWidget*>()) {
            const QString name = isControl(*widget) ? nameOf(*widget) : QString();
            const QString title = dock->windowTitle() + QStringLiteral(": ") + name;
            if (name.isEmpty() || !widget->isEnabled() || known.contains(title) || !couldShow(*widget, *panel))
                continue;
            known.insert(title);
            entries.push_back({title, {}, widget->toolTip(), dock->toggleViewAction()->icon(), [widget] { showControl(*widget); }});
        }
    }
    return entries;
}

void showControl(QWidget& control)
{
    for (QWidget* at = &control; at; at = at->parentWidget()) {
        if (QTabWidget* tabs = tabsOf(*at))
            tabs->setCurrentWidget(at);
        if (auto* dock = qobject_cast<QDockWidget*>(at)) {
            dock->show();
            dock->raise();
            dock->widget()->show(); // it rests behind a tab
        }
    }
    for (QWidget* at = control.parentWidget(); at; at = at->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(at))
            scroll->ensureWidgetVisible(&control);
    control.window()->activateWindow();
    if (auto* number = qobject_cast<NumberField*>(&control)) {
        number->box()->setFocus(Qt::ShortcutFocusReason);
        number->box()->selectAll();
    } else {
        control.setFocus(Qt::ShortcutFocusReason);
    }
}

} // namespace mirrorball::studio
