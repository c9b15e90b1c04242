#pragma once

#include "core/spheremap/layers/adjust.h"

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <string_view>
#include <vector>

namespace mirrorball::studio {

/// The largest value that a coordinate of a CurvePoint takes: "x" or "y".
double curveFieldHigh(std::string_view name);

/// The square of a tone curve with its points as handles. Press on an empty place for a new point, drag a point to move it between its
/// neighbors, pull it away to remove it, double-click it to put it back on the diagonal. Arrow keys move the chosen point (Shift: finer),
/// Ctrl and arrows go from point to point, Delete removes it, Insert adds one behind it.
///
/// The curve is what core's CurveTable makes of the points. They are shown and given in order from left to right.
class CurvePlot : public QWidget {
    Q_OBJECT

public:
    explicit CurvePlot(QWidget* parent = nullptr);

    void setPoints(const std::vector<CurvePoint>& points);
    void setChannels(AdjustedChannels channels);
    const std::vector<CurvePoint>& points() const { return m_points; }
    int chosen() const { return m_chosen; }
    void choose(int index);
    void addPoint(const CurvePoint& point);
    void removeChosen();
    /// Moves the chosen point as the user would, as far as its neighbors and the fields' ranges let it.
    void moveChosen(double x, double y);
    /// The curve that changes nothing.
    void reset();
    /// Where on the widget a point is, and back.
    QPointF placeOf(double x, double y) const;
    CurvePoint pointAt(const QPointF& place) const;

    QSize sizeHint() const override { return {240, 240}; }
    QSize minimumSizeHint() const override { return {160, 240}; }

signals:
    void edited(const std::vector<mirrorball::CurvePoint>& points);
    void finished();
    void chosenChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF square() const;
    void fitTop();
    int handleAt(const QPointF& place) const;
    bool insert(const CurvePoint& point);
    void paintGround(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;

    std::vector<CurvePoint> m_points{};
    AdjustedChannels m_channels = AdjustedChannels::All;
    double m_top = 1.0; ///< y of the upper edge
    int m_chosen = 0;
    bool m_isDragging = false;
    bool m_isNew = false;                   ///< the last press added the chosen point
    QPointF m_grabbed{};                    ///< of the dragged point, less the mouse
    std::vector<CurvePoint> m_beforePull{}; ///< the points while the dragged one is pulled away
};

} // namespace mirrorball::studio
