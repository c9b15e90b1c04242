#pragma once

#include "widgets/controls/direction_cursor.h"
#include "widgets/workspace/job_runner.h"

#include "core/image/map_picture.h"

#include <QImage>
#include <QPointF>
#include <QString>
#include <QWidget>

#include <memory>
#include <optional>

namespace mirrorball::studio {

/// One map in one parameterization: zoom, pan, exposure, false colors and overlays. Pictures are made in the background, the newest
/// request wins; until it is there the last one is shown where it belongs.
///
/// The wheel and + and - zoom, dragging and the arrow keys pan, a double click or 0 fits, 1 shows a texel on a pixel; Shift and the arrow
/// keys move the direction cursor texel by texel.
class MapView : public QWidget {
    Q_OBJECT

public:
    explicit MapView(DirectionCursor& cursor, QWidget* parent = nullptr);

    /// Shows a map laid out as `layout`; the view stays where it is when only the size changes.
    void showMap(std::shared_ptr<const EnvironmentMap> map, const MapLayout& layout);
    /// Shows words in place of a map.
    void showMessage(const QString& message);
    void setColoring(const MapColoring& coloring);
    void setOverlays(const MapOverlays& overlays);
    /// A line in the corner that says what is shown; empty: none.
    void setCaption(const QString& caption);

    const std::shared_ptr<const EnvironmentMap>& map() const { return m_map; }
    const QString& message() const { return m_message; }
    const MapWindow& window() const { return m_window; }
    const MapColoring& coloring() const { return m_coloring; }
    const MapOverlays& overlays() const { return m_overlays; }
    /// Whether the picture on the screen is the one that was asked for.
    bool isUpToDate() const { return m_map == nullptr || (!m_runner.isBusy() && !m_isStale); }
    /// The picture as it is on the screen now.
    const QImage& picture() const { return m_picture; }

    /// The direction under a position of the widget; nothing beside the map.
    std::optional<glm::dvec3> directionAt(const QPointF& position) const;
    /// The position of a direction in the widget.
    QPointF positionOf(const glm::dvec3& direction) const;
    /// Radiance that the view shows for a direction: that of the texel where the map is shown in its own layout, else a lookup.
    glm::vec3 valueAt(const glm::dvec3& direction) const;
    double zoom() const { return m_window.scale; } ///< pixels a texel

    QSize sizeHint() const override { return {360, 200}; }
    QSize minimumSizeHint() const override { return {120, 80}; }

public slots:
    void fit();
    void actualSize();
    void zoomBy(double factor);

signals:
    void zoomChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    struct Rendered;
    void fitNow();
    void zoomAt(const QPointF& position, double factor);
    void pan(const QPointF& pixels);
    void moveCursor(int right, int down);
    void request();
    void paintMarks(QPainter& painter);
    void paintMarker(QPainter& painter, const QPointF& at) const;
    double ratio() const { return devicePixelRatioF(); }

    DirectionCursor& m_cursor;
    JobRunner m_runner;
    std::shared_ptr<const EnvironmentMap> m_map;
    QString m_message, m_caption;
    MapWindow m_window{};
    MapColoring m_coloring{};
    MapOverlays m_overlays{};
    bool m_isFitted = true;
    bool m_isStale = true; ///< a request is due that waits for the widget to be shown
    QPointF m_last;
    bool m_isPanning = false;
    std::shared_ptr<const Rendered> m_rendered; ///< what the worker made last: parts of it serve the next request
    QImage m_picture, m_overlay;
    MapWindow m_pictureWindow{};
};

} // namespace mirrorball::studio
