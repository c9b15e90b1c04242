#include "command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

int matchScore(const QString& typed, const QString& text)
{
    int score = 1, run = 0;
    qsizetype at = 0;
    for (const QChar letter : typed) {
        if (letter.isSpace()) {
            run = 0;
            continue;
        }
        const qsizetype found = text.indexOf(letter, at, Qt::CaseInsensitive);
        if (found < 0)
            return 0;
        run = found == at && at > 0 ? run + 1 : 0;
        const bool startsWord = found == 0 || !text[found - 1].isLetterOrNumber();
        score += 1 + 3 * run + (startsWord ? 4 : 0);
        at = found + 1;
    }
    return score;
}

CommandPalette::CommandPalette(QMainWindow& window)
    : QDialog(&window, Qt::Popup | Qt::FramelessWindowHint), m_input(new QLineEdit(this)), m_list(new QListWidget(this))
{
    setObjectName(QStringLiteral("commandPalette"));
    setAccessibleName(tr("Command palette"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_input->setPlaceholderText(tr("Type a command, or the name of a control"));
    m_input->setAccessibleName(tr("Command"));
    m_input->setToolTip(tr("Letters of it, in their order"));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setToolTip(tr("Enter or click runs the command, or goes to the control"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // what is too long ends in an ellipsis
    m_list->setFocusPolicy(Qt::NoFocus);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(m_input);
    column->addWidget(m_list);

    m_entries = commandEntries(window) + controlEntries(window);
    QPixmap nothing(32, 32); // so that words begin in one line
    nothing.fill(Qt::transparent);
    const QIcon noIcon(nothing);
    for (int i = 0; i < m_entries.size(); ++i) {
        const PaletteEntry& entry = m_entries[i];
        auto* item = new QListWidgetItem(entry.icon.isNull() ? noIcon : entry.icon,
                                         entry.keys.isEmpty() ? entry.title : entry.title + QStringLiteral("   ") + entry.keys, m_list);
        item->setData(Qt::UserRole, i);
        item->setData(Qt::UserRole + 1, entry.title);
        item->setToolTip(entry.help);
    }
    connect(m_input, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::run);
    m_input->installEventFilter(this);
    m_input->setFocus();
    filter({});

    const int width = std::min(560, window.width() - 40), height = std::min(420, window.height() - 80);
    resize(width, height);
    move(window.mapToGlobal(QPoint((window.width() - width) / 2, 60)));
}

void CommandPalette::filter(const QString& typed)
{
    QListWidgetItem* best = nullptr;
    int bestScore = 0;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const int score = matchScore(typed, item->data(Qt::UserRole + 1).toString());
        item->setHidden(score == 0);
        if (score > bestScore) {
            best = item;
            bestScore = score;
        }
    }
    m_list->setCurrentItem(best);
}

void CommandPalette::run()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (!item || item->isHidden())
        return;
    const std::function<void()> act = m_entries[item->data(Qt::UserRole).toInt()].run;
    close();
    act();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_input || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        QApplication::sendEvent(m_list, event);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        run();
        return true;
    default:
        return false;
    }
}

} // namespace mirrorball::studio
