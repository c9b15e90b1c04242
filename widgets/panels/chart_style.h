#pragma once

#include <QtCharts/QAbstractAxis>
#include <QtCharts/QChart>
#include <QtCharts/QChartView>

namespace mirrorball::studio {

/// A chart's look in the studio: on dark gray, without a frame or room around it.
void styleChart(QChartView& view);
void styleAxis(QAbstractAxis& axis, const QFont& font);

} // namespace mirrorball::studio
