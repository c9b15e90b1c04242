#include "probe_filter.h"

#include "widgets/workspace/probe_library.h"

namespace mirrorball::studio {

void ProbeFilter::setGroup(const QString& group)
{
    m_group = group;
    invalidateFilter();
}

void ProbeFilter::setText(const QString& text)
{
    m_text = text;
    invalidateFilter();
}

bool ProbeFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    return (m_group.isEmpty() || index.data(ProbeLibrary::GroupRole).toString() == m_group) &&
           (m_text.isEmpty() || index.data().toString().contains(m_text, Qt::CaseInsensitive));
}

} // namespace mirrorball::studio
