#pragma once

#include "sphere_map_editor.h"

#include "core/spheremap/evaluation/disc_handles.h"

#include <QObject>
#include <QPainter>
#include <QPointF>

#include <functional>
#include <optional>
#include <vector>

class QKeyEvent;

namespace mirrorball::studio {

/// The chosen layer's handles on a disc, and its mask's, to be dragged: lights as small suns, centers, arms, rings
/// (core/spheremap/evaluation/disc_handles.h). The canvas hands on what mouse and keys do. What lies on the ball's back is shown at the
/// rim, hollow.
///
/// A drag is one undo step, Escape gives it up. Arrow keys move the chosen handle (Shift: finer), Ctrl and arrows go from one to the next.
/// On a list of lights a double click adds one and Delete removes the one chosen.
class DiscHandles : public QObject {
    Q_OBJECT

public:
    /// Where the disc is on the widget, both ways.
    struct View {
        std::function<QPointF(const glm::dvec2&)> placeOf;
        std::function<glm::dvec2(const QPointF&)> discAt;
    };
    DiscHandles(SphereMapEditor& editor, View view, QObject* parent = nullptr);

    /// Whether a press belongs to handles: the chosen layer has some, or takes lights, and nothing is painted or picked.
    bool isActive() const { return m_isActive; }
    /// The layer's, then the mask's.
    const std::vector<DiscHandle>& handles() const { return m_handles; }
    bool isOfMask(int handle) const { return handle >= m_ofLayer; }
    /// -1 without handles.
    int chosen() const { return m_chosen; }
    void choose(int handle);
    /// Where a handle is drawn.
    QPointF shownAt(int handle) const;
    /// The handle at a place of the widget, or -1.
    int at(const QPointF& place) const;
    /// What it is and its values, in a line.
    QString describe(int handle) const;
    /// What a press beside the handles could have been for.
    QString hint() const;

    /// True where a handle is there: it then follows move().
    bool press(const QPointF& place);
    /// Adds a light where the layer takes one; it then follows move().
    bool addAt(const QPointF& place);
    void move(const QPointF& place);
    void release();
    void cancel();
    bool isDragging() const { return m_drag.has_value(); }
    bool isHovered() const { return m_hovered >= 0; }
    void hover(const std::optional<QPointF>& place);
    /// True for keys that mean something here.
    bool pressKey(const QKeyEvent& event);
    void releaseKey();

    enum class Focus { None, Keys };
    /// @param area  of the widget, which notes keep to
    void paint(QPainter& painter, const QRectF& area, Focus focus) const;

signals:
    /// Which handles there are, where, or which is chosen.
    void changed();

private:
    void follow();
    void followLight();
    void edit(const QString& label, const std::function<void(LayerContent&)>& change);
    void moveChosen(const glm::dvec2& wanted);
    void dragFrom(const QPointF& place);
    void nudge(const glm::dvec2& by);
    void removeChosen();

    struct Drag {
        glm::dvec2 grabbed{0.0}; ///< the handle's place less the mouse's, when it was taken
        LayerContent before{};
    };
    SphereMapEditor& m_editor;
    View m_view;
    std::vector<DiscHandle> m_handles{};
    int m_ofLayer = 0; ///< how many of them are the layer's own
    bool m_isActive = false;
    int m_chosen = -1;
    int m_hovered = -1;
    std::optional<Drag> m_drag{};
};

} // namespace mirrorball::studio
