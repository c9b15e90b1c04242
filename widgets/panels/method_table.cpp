#include "method_table.h"

#include "method_chart.h"
#include "widgets/controls/color_scale_bar.h"
#include "widgets/controls/text.h"

#include <QHeaderView>
#include <QSignalBlocker>

namespace mirrorball::studio {

namespace {

enum Column { MethodColumn, TimeColumn, ErrorColumn, SettingColumn, ColumnCount };

QString stateText(MeasurementState state)
{
    switch (state) {
    case MeasurementState::Refused:
        return MethodTable::tr("refused");
    case MeasurementState::LeftOut:
        return MethodTable::tr("too slow");
    case MeasurementState::Failed:
        return MethodTable::tr("failed");
    default:
        return {};
    }
}

/// Rows sort by their figures, not by their texts.
class Row : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;
    bool operator<(const QTreeWidgetItem& other) const override
    {
        const int column = treeWidget()->sortColumn();
        const QVariant mine = data(column, Qt::UserRole + 1), theirs = other.data(column, Qt::UserRole + 1);
        return mine.isValid() && theirs.isValid() ? mine.toDouble() < theirs.toDouble() : text(column) < other.text(column);
    }
};

} // namespace

QString secondsText(double seconds)
{
    if (seconds < 1e-3)
        return QStringLiteral("%1 us").arg(1e6 * seconds, 0, 'f', 0);
    if (seconds < 1.0)
        return QStringLiteral("%1 ms").arg(1e3 * seconds, 0, 'f', seconds < 0.01 ? 2 : 1);
    return QStringLiteral("%1 s").arg(seconds, 0, 'f', seconds < 10.0 ? 2 : 0);
}

MethodTable::MethodTable(QWidget* parent) : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("report.table"));
    setAccessibleName(tr("Methods"));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setHeaderLabels({tr("Method"), tr("Time"), tr("rel_rms"), tr("Setting")});
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(SettingColumn, QHeaderView::Stretch);
    setSortingEnabled(true);
    sortByColumn(TimeColumn, Qt::AscendingOrder);
    setToolTip(tr("Picks the method of a row; refused and slow ones say why when pointed at"));
    setMinimumHeight(60);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        if (item)
            emit picked(item->data(MethodColumn, Qt::UserRole).toInt());
    });
}

void MethodTable::add(const RacePoint& point)
{
    const bool isMeasured = point.state == MeasurementState::Measured;
    const QSignalBlocker blocker(this);
    auto* row =
        new Row(QStringList{fieldText(name(point.setting.method)), isMeasured ? secondsText(point.seconds) : stateText(point.state),
                            !isMeasured || point.setting.method == Method::Reference ? QString() : shortNumberText(point.error.relRms),
                            toQString(point.setting.label)});
    row->setData(MethodColumn, Qt::UserRole, topLevelItemCount());
    row->setData(TimeColumn, Qt::UserRole + 1, isMeasured ? point.seconds : 1e9);
    row->setData(ErrorColumn, Qt::UserRole + 1, isMeasured ? point.error.relRms : 1e9);
    row->setTextAlignment(TimeColumn, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(ErrorColumn, Qt::AlignRight | Qt::AlignVCenter);
    row->setForeground(MethodColumn, isMeasured ? methodColor(point.setting.method) : palette().color(QPalette::PlaceholderText));
    if (!isMeasured)
        for (int column = TimeColumn; column < ColumnCount; ++column)
            row->setForeground(column, palette().color(QPalette::PlaceholderText));
    for (int column = MethodColumn; column < ColumnCount; ++column)
        row->setToolTip(column, toQString(point.why));
    addTopLevelItem(row);
}

void MethodTable::setPicked(int index)
{
    const QSignalBlocker blocker(this);
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (topLevelItem(row)->data(MethodColumn, Qt::UserRole).toInt() == index)
            setCurrentItem(topLevelItem(row));
}

} // namespace mirrorball::studio
