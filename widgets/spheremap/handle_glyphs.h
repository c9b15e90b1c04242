#pragma once

#include "core/spheremap/evaluation/disc_handles.h"

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>

/// How handles on a disc look: light lines with a dark edge, which show on every color.
namespace mirrorball::studio {

struct HandleGlyph {
    HandleKind kind = HandleKind::Place;
    QPointF place{};
    QPointF from{}; ///< arms, rings
    std::optional<glm::dvec3> color{};
    bool isChosen = false;
    bool isHovered = false;
    bool hasFocus = false; ///< of the keyboard: the chosen one is marked
    bool isOfMask = false; ///< drawn with broken lines, and empty
    bool isBehind = false; ///< on the ball's back
};

void paintHandle(QPainter& painter, const HandleGlyph& glyph);
/// A line of text beside a handle, kept within an area.
void paintHandleNote(QPainter& painter, const QPointF& place, const QString& note, const QRectF& area);

} // namespace mirrorball::studio
