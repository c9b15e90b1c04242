#include "notice_panel.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace mirrorball::studio {

NoticePanel::NoticePanel(Notices& notices, QWidget* parent) : QWidget(parent), m_notices(notices), m_column(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("notices"));
    setAccessibleName(tr("Notices"));
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(1);
    connect(&m_notices, &Notices::changed, this, &NoticePanel::refresh, Qt::QueuedConnection); // a strip's own button may be the cause
    refresh();
}

void NoticePanel::refresh()
{
    while (QLayoutItem* item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const Notices::Notice& notice : m_notices.all())
        m_column->addWidget(makeStrip(notice));
    setVisible(!m_notices.all().isEmpty());
}

QWidget* NoticePanel::makeStrip(const Notices::Notice& notice)
{
    auto* strip = new QFrame(this);
    strip->setProperty("role", QStringLiteral("notice"));
    auto* row = new QHBoxLayout(strip);
    row->setContentsMargins(10, 4, 6, 4);
    auto* sign = new QLabel(strip);
    sign->setPixmap(QIcon(QStringLiteral(":/icons/warning.svg")).pixmap(16, 16));
    row->addWidget(sign);
    auto* words = new QLabel(notice.text, strip);
    words->setWordWrap(true);
    words->setTextFormat(Qt::PlainText);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    words->setAccessibleName(notice.text);
    words->setToolTip(tr("What is wrong, and what to do about it"));
    row->addWidget(words, 1);
    if (!notice.actionText.isEmpty()) {
        auto* action = new QPushButton(notice.actionText, strip);
        action->setAccessibleName(notice.actionText);
        action->setToolTip(notice.actionText);
        connect(action, &QPushButton::clicked, this, [act = notice.action] { act(); });
        row->addWidget(action);
    }
    auto* close = new QToolButton(strip);
    close->setIcon(QIcon(QStringLiteral(":/icons/close.svg")));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Close this notice"));
    close->setToolTip(tr("Close this notice"));
    connect(close, &QToolButton::clicked, this, [this, subject = notice.subject] { m_notices.clear(subject); });
    row->addWidget(close);
    return strip;
}

} // namespace mirrorball::studio
