#pragma once

#include "options_form.h"

#include "core/spheremap/math/gradient_table.h"

#include <QDoubleSpinBox>
#include <QWidget>

#include <vector>

namespace mirrorball::studio {

/// The bar of a gradient with its stops as handles below it. Click a handle to choose it, drag to move it, pull it away to remove it;
/// double-click the bar for a new one. Arrow keys move the chosen stop (Shift: finer), Delete removes it, Insert adds one, Ctrl and arrows
/// go from stop to stop.
class GradientBar : public QWidget {
    Q_OBJECT

public:
    explicit GradientBar(QWidget* parent = nullptr);

    void setStops(const std::vector<GradientStop>& stops);
    const std::vector<GradientStop>& stops() const { return m_stops; }
    int chosen() const { return m_chosen; }
    void choose(int index);
    void addStop(double position);
    void removeChosen();
    /// Changes the chosen stop as the user would.
    void changeChosen(const std::function<void(GradientStop&)>& change);
    /// Where across the widget a position of the gradient is.
    double placeOf(double position) const;

    QSize sizeHint() const override { return {200, 44}; }
    QSize minimumSizeHint() const override { return {100, 44}; }

signals:
    void edited(const std::vector<mirrorball::GradientStop>& stops);
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
    QRectF bar() const;
    double positionAt(double x) const;
    int handleAt(const QPointF& place) const;

    std::vector<GradientStop> m_stops{};
    int m_chosen = 0;
    bool m_isDragging = false;
    std::vector<GradientStop> m_beforePull{}; ///< the stops while the dragged one is pulled away
};

/// A gradient's stops: the bar, and the chosen stop's color, position and opacity.
class GradientEditor : public QWidget {
    Q_OBJECT

public:
    explicit GradientEditor(QWidget* parent = nullptr);

    /// Shows stops; says nothing to anybody.
    void setStops(const std::vector<GradientStop>& stops);
    GradientBar& bar() { return *m_bar; }

signals:
    void edited(const std::vector<mirrorball::GradientStop>& stops);
    void finished();

private:
    void showChosen();

    GradientBar* m_bar;
    ColorButton* m_color;
    QDoubleSpinBox* m_position;
    QDoubleSpinBox* m_opacity;
};

} // namespace mirrorball::studio
