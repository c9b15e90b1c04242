#pragma once

#include "preview_widget.h"

#include <QObject>

namespace mirrorball::studio {

/// Painting on the model: what the pen touches in the preview is painted on the sphere map at the place that colours it there (the normal or
/// the reflection, spheremap/paint_position.h), so a highlight is put where it is to be seen.
///
/// On while SphereMapEditor::paintsOnModel(): left draws in place of orbiting, Alt and left orbits. Off the model the pen is lifted.
class ModelPainter : public QObject {
    Q_OBJECT

public:
    ModelPainter(PreviewWidget& preview, Workspace& workspace);

    /// The place on the disc that colours a place of the preview; nothing beside the model.
    std::optional<glm::dvec2> placeAt(const QPointF& position);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool press(const QPointF& position, Qt::KeyboardModifiers modifiers, double pressure, PenEnd end);
    void move(const QPointF& position, double pressure);
    void release();

    PreviewWidget& m_preview;
    Workspace& m_workspace;
    bool m_isPainting = false;
    bool m_isPicking = false;
    bool m_penIsDown = false;
    bool m_hasBegun = false;  ///< the pen has met the model since it was pressed
    PenEnd m_end = PenEnd::Tip;
};

} // namespace mirrorball::studio
