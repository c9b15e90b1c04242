#pragma once

#include <QSortFilterProxyModel>
#include <QString>

namespace mirrorball::studio {

/// The probes of one group whose names hold a text; empty ones leave all of them.
class ProbeFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setGroup(const QString& group);
    void setText(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString m_group, m_text;
};

} // namespace mirrorball::studio
