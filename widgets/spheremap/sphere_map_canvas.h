#pragma once

#include "disc_handles.h"
#include "sphere_map_editor.h"

#include "core/spheremap/strokes/pulled_string.h"

#include <QPointF>
#include <QWidget>

namespace mirrorball::studio {

/// The disc, to paint on with mouse or pen, or with the handles of the chosen layer.
///
/// Left draws with the chosen tool, a pen with its pressure, its eraser end erases, steadied by the editor's stabilizer; on a layer with
/// places and directions it drags their handles instead, and keys move them (DiscHandles). Alt picks a color. Right drag changes the brush:
/// across its radius, up and down its hardness; [ and ] step the radius. The wheel zooms at the cursor, middle or Space and left drag pans,
/// Home fits. Escape gives up the stroke or the drag at hand, and shows all levels again where one is shown alone.
class SphereMapCanvas : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapCanvas(SphereMapEditor& editor, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {320, 300}; }
    QSize minimumSizeHint() const override { return {160, 160}; }
    bool hasHeightForWidth() const override { return false; }

    /// The place of the disc at a place of the widget, and back.
    glm::dvec2 discAt(const QPointF& place) const;
    QPointF placeOf(const glm::dvec2& q) const;

    DiscHandles& handles() { return m_handles; }

public slots:
    void fit();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag { None, Stroke, Pan, Brush, Pick, Handle };

    double scale() const; ///< pixels to a disc radius
    /// Where the brush is while a stroke is drawn.
    QPointF brushPlace() const { return {m_string.brush().x, m_string.brush().y}; }
    void show(const TexelRect& touched);
    void press(const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const PenTouch& touch);
    void move(const QPointF& place, const PenTouch& touch);
    void release();
    void paintBrush(QPainter& painter) const;
    void paintWords(QPainter& painter, const QString& words, Qt::Alignment where, const QColor& color) const;
    void paintSymmetry(QPainter& painter) const;
    void updateCursor();

    SphereMapEditor& m_editor;
    DiscHandles m_handles;
    double m_zoom = 1.0;
    glm::dvec2 m_center{0.0}; ///< place of the disc in the middle of the widget
    Drag m_drag = Drag::None;
    bool m_spaceIsDown = false;
    bool m_penIsDown = false; ///< its mouse events are left out
    QPointF m_last;
    QPointF m_pressed;
    PulledString m_string{}; ///< of the stroke at hand, in the widget's pixels
    Brush m_brushBefore{};
    std::optional<QPointF> m_cursor;
    QString m_hint; ///< why a press drew nothing
};

} // namespace mirrorball::studio
