#pragma once

#include "core/report/method_race.h"

#include <QTreeWidget>

namespace mirrorball::studio {

/// A run time in us, ms or s.
QString secondsText(double seconds);

/// The points of a MethodChart as rows: method, run time, error, setting; sorted by their figures. What was refused or too slow says why
/// when pointed at.
class MethodTable : public QTreeWidget {
    Q_OBJECT

public:
    explicit MethodTable(QWidget* parent = nullptr);

    /// Appends the next point: rows are known by the order in which they came.
    void add(const RacePoint& point);
    void setPicked(int index);

signals:
    void picked(int index);
};

} // namespace mirrorball::studio
