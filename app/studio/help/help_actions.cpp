#include "help_actions.h"

#include "guide.h"
#include "shortcut_list.h"

#include "app/studio/menu_action.h"
#include "app/studio/theme.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMessageBox>
#include <QMouseEvent>
#include <QStatusTipEvent>

namespace mirrorball::studio {

HelpActions::HelpActions(QMainWindow& window, Tour& tour) : QObject(&window), m_window(window), m_tour(tour) {}

HelpActions::~HelpActions() { stopAsking(); }

HelpWindow& HelpActions::help()
{
    if (!m_help) {
        m_help = std::make_unique<HelpWindow>();
        m_help->setWindowIcon(m_window.windowIcon());
    }
    return *m_help;
}

void HelpActions::addTo(QMenu& menu)
{
    const auto add = [&](const char* id, const QString& text, const QString& tip, const QKeySequence& key, auto slot) {
        return addCommand(menu, id, {}, text, tip, key, this, slot);
    };
    add("help.page", tr("&Help on this panel"), tr("Open the guide at the page of the panel that has the keys"), QKeySequence(Qt::Key_F1),
        [this] { showFor(QApplication::focusWidget()); });
    add("help.what", tr("&What's this?"), tr("Click anything next: the guide opens where it is explained"),
        QKeySequence(Qt::SHIFT | Qt::Key_F1), &HelpActions::ask);
    add("help.guide", tr("The &guide"), tr("All pages of the guide"), {}, [this] { help().showPage(guidePages().front().file); });
    add("help.keys", tr("&Keyboard shortcuts"), tr("Every key of the studio"), QKeySequence(Qt::CTRL | Qt::Key_Slash),
        [this] { help().showHtml(tr("Keyboard shortcuts"), shortcutsHtml(m_window)); });
    menu.addSeparator();
    add("help.tour", tr("&Tour of the studio"), tr("Five steps from a light to maps for an engine"), {}, [this] { m_tour.start(); });
    menu.addSeparator();
    QAction* about = add("help.about", tr("&About Mirrorball Studio"), tr("Version and license"), {}, [this] {
        QMessageBox::about(&m_window, tr("Mirrorball Studio"),
                           tr("<b>Mirrorball Studio %1</b><p>Materials with environment maps.<p>GPL-3.0-or-later")
                               .arg(QApplication::applicationVersion()));
    });
    about->setMenuRole(QAction::AboutRole);
}

void HelpActions::serve(QWidget& dialog, const QString& page)
{
    setHelpPage(dialog, page);
    auto* key = new QAction(tr("Help"), &dialog);
    key->setShortcut(QKeySequence(Qt::Key_F1));
    connect(key, &QAction::triggered, this, [this, page] { help().showPage(page); });
    dialog.addAction(key);
}

void HelpActions::showFor(const QWidget* widget) { help().showPage(helpPageOf(widget)); }

void HelpActions::ask()
{
    if (m_isAsking)
        return;
    m_isAsking = true;
    QApplication::setOverrideCursor(Qt::WhatsThisCursor);
    qApp->installEventFilter(this);
    QStatusTipEvent tip(tr("Click what you want to know about; Escape ends this"));
    QApplication::sendEvent(&m_window, &tip);
}

void HelpActions::stopAsking()
{
    if (!m_isAsking)
        return;
    m_isAsking = false;
    qApp->removeEventFilter(this);
    QApplication::restoreOverrideCursor();
    QStatusTipEvent none{QString()};
    QApplication::sendEvent(&m_window, &none);
}

bool HelpActions::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    const bool isEscape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    const bool isClick = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (!widget || (!isEscape && !isClick))
        return false;
    stopAsking();
    if (isClick) {
        const QWidget* inner = widget->childAt(static_cast<QMouseEvent*>(event)->position().toPoint());
        const QWidget* asked = inner ? inner : widget;
        help().showPage(helpPageOf(asked), asked->accessibleName());
    }
    return true;
}

} // namespace mirrorball::studio
