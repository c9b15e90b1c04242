#pragma once

#include "preview_widget.h"
#include "widgets/spheremap/brush_ring.h"

#include "core/spheremap/strokes/pulled_string.h"

#include <QObject>
#include <QTimer>

namespace mirrorball::studio {

/// Painting on the model: what the pen touches in the preview is painted on the sphere map at the place that colors it there
/// (preview/disc_places.h), so a highlight is put where it is to be seen.
///
/// On while SphereMapEditor::paintsOnModel(): left draws in place of orbiting, Alt and left orbits, right drag changes the brush as on the
/// disc. Off the model the pen is lifted. The stabilizer's string lies in the picture, so that it is as long everywhere on the model. A
/// ring shows what the brush would touch.
class ModelPainter : public QObject {
    Q_OBJECT

public:
    ModelPainter(PreviewWidget& preview, Workspace& workspace);

    /// The place on the disc that colors a place of the preview; nothing beside the model.
    std::optional<glm::dvec2> placeAt(const QPointF& position);
    const BrushRing& ring() const { return *m_ring; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOn() const { return m_workspace.sphereMap.paintsOnModel() && m_workspace.sphereMap.map(); }
    bool press(const QPointF& position, Qt::KeyboardModifiers modifiers, const PenTouch& touch);
    void pick(const QPointF& position);
    void move(const QPointF& position, const PenTouch& touch);
    void release();
    bool handleMouse(QEvent* event);
    bool handlePen(QEvent* event);
    void showRing();
    QPolygonF outlineAt(const QPointF& position);

    PreviewWidget& m_preview;
    Workspace& m_workspace;
    BrushRing* m_ring;  ///< the preview's child
    QTimer m_ringTimer; ///< a moving mouse looks at the model this often
    std::optional<QPointF> m_cursor{};
    bool m_isPainting = false;
    bool m_isPicking = false;
    bool m_penIsDown = false;
    bool m_hasBegun = false;              ///< the pen has met the model since it was pressed
    std::optional<Brush> m_brushBefore{}; ///< while a right drag changes it
    QPointF m_pressed;
    PulledString m_string{}; ///< of the stroke at hand, in the preview's pixels
    PenEnd m_end = PenEnd::Tip;
};

} // namespace mirrorball::studio
