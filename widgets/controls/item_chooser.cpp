#include "item_chooser.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QSignalBlocker>

namespace mirrorball::studio {

ItemChooser::ItemChooser(int least, int most, QWidget* parent)
    : QWidget(parent), m_least(least), m_most(most), m_numbers(new QTabBar(this)), m_add(new QToolButton(this)),
      m_remove(new QToolButton(this))
{
    m_numbers->setDrawBase(false);
    m_numbers->setExpanding(false);
    m_numbers->setUsesScrollButtons(true);
    m_add->setIcon(QIcon(QStringLiteral(":/icons/add.svg")));
    m_remove->setIcon(QIcon(QStringLiteral(":/icons/delete.svg")));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(m_numbers, 1);
    for (QToolButton* button : {m_add, m_remove}) {
        button->setAutoRaise(true);
        row->addWidget(button);
    }
    connect(m_numbers, &QTabBar::currentChanged, this, &ItemChooser::chosenChanged);
    connect(m_add, &QToolButton::clicked, this, &ItemChooser::addRequested);
    connect(m_remove, &QToolButton::clicked, this, &ItemChooser::removeRequested);
    setCount(0);
}

void ItemChooser::setCount(int count)
{
    {
        const QSignalBlocker quiet(m_numbers);
        while (m_numbers->count() < count)
            m_numbers->addTab(QString::number(m_numbers->count() + 1));
        while (m_numbers->count() > count)
            m_numbers->removeTab(m_numbers->count() - 1);
    }
    m_add->setEnabled(count < m_most);
    m_remove->setEnabled(count > m_least);
}

void ItemChooser::describe(const QString& items, const QString& help)
{
    m_numbers->setAccessibleName(items);
    m_numbers->setToolTip(help);
    m_add->setAccessibleName(tr("Add to %1").arg(items.toLower()));
    m_add->setToolTip(tr("Add one like the one chosen"));
    m_remove->setAccessibleName(tr("Remove from %1").arg(items.toLower()));
    m_remove->setToolTip(tr("Remove the one chosen"));
}

} // namespace mirrorball::studio
