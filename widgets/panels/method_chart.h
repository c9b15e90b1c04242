#pragma once

#include "core/report/method_race.h"

#include <QtCharts/QChartView>
#include <QtCharts/QLineSeries>
#include <QtCharts/QLogValueAxis>
#include <QtCharts/QScatterSeries>

#include <map>
#include <optional>
#include <vector>

namespace mirrorball::studio {

/// The color that stands for a method, wherever it is shown.
QColor methodColor(Method method);

/// Error against run time, both logarithmic: a point a setting, a color a method, a line for the front.
class MethodChart : public QChartView {
    Q_OBJECT

public:
    explicit MethodChart(QWidget* parent = nullptr);

    void setPoints(const std::vector<RacePoint>& points);
    void setPicked(int index);
    /// Where a point is drawn, in the widget; nothing for one that was not measured.
    std::optional<QPointF> positionOf(int index) const;

    QSize minimumSizeHint() const override { return {200, 120}; }

signals:
    void picked(int index);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int pointAt(const QPointF& position) const;
    void fitAxes();
    void fitLabels();

    QLogValueAxis *m_time, *m_error;
    std::map<Method, QScatterSeries*> m_series;
    QLineSeries* m_front;
    QScatterSeries* m_ring;
    std::vector<RacePoint> m_points;
    int m_picked = -1;
};

} // namespace mirrorball::studio
