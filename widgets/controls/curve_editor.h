#pragma once

#include "curve_plot.h"

#include <QDoubleSpinBox>
#include <QToolButton>
#include <QWidget>

#include <vector>

namespace mirrorball::studio {

/// A tone curve: the plot, the chosen point's numbers, and a way back to the curve that changes nothing.
class CurveEditor : public QWidget {
    Q_OBJECT

public:
    explicit CurveEditor(QWidget* parent = nullptr);

    /// Shows points; says nothing to anybody.
    void setPoints(const std::vector<CurvePoint>& points);
    /// Which channels the curve is for: it is drawn in their color.
    void setChannels(AdjustedChannels channels) { m_plot->setChannels(channels); }
    CurvePlot& plot() { return *m_plot; }
    QDoubleSpinBox& before() { return *m_before; }
    QDoubleSpinBox& after() { return *m_after; }
    QToolButton& resetButton() { return *m_reset; }

signals:
    void edited(const std::vector<mirrorball::CurvePoint>& points);
    void finished();

private:
    void showChosen();

    CurvePlot* m_plot;
    QDoubleSpinBox* m_before;
    QDoubleSpinBox* m_after;
    QToolButton* m_reset;
};

} // namespace mirrorball::studio
