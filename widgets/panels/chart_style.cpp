#include "chart_style.h"

#include <QGraphicsLayout>

namespace mirrorball::studio {

void styleChart(QChartView& view)
{
    view.setRenderHint(QPainter::Antialiasing);
    view.setFrameShape(QFrame::NoFrame);
    QChart* chart = view.chart();
    chart->setBackgroundBrush(QColor(0x1c, 0x1c, 0x1c));
    chart->setBackgroundRoundness(0);
    chart->setMargins(QMargins(2, 2, 6, 2));
    chart->layout()->setContentsMargins(0, 0, 0, 0);
}

void styleAxis(QAbstractAxis& axis, const QFont& font)
{
    axis.setLabelsColor(QColor(0xbb, 0xbb, 0xbb));
    axis.setTitleBrush(QColor(0xbb, 0xbb, 0xbb));
    axis.setGridLineColor(QColor(0x38, 0x38, 0x38));
    axis.setLinePenColor(QColor(0x55, 0x55, 0x55));
    QFont small = axis.labelsFont();
    small.setPointSizeF(0.85 * font.pointSizeF());
    axis.setLabelsFont(small);
    axis.setTitleFont(small);
}

} // namespace mirrorball::studio
