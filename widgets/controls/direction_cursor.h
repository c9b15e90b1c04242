#pragma once

#include <QObject>

#include <glm/glm.hpp>

#include <optional>

namespace mirrorball::studio {

/// The direction that the mouse points at, in a map or on the model: whoever shows directions marks it. Not part of the document.
class DirectionCursor : public QObject {
    Q_OBJECT

public:
    /// Unit, in the map's frame (before the environment's yaw); nothing while nothing is pointed at.
    const std::optional<glm::dvec3>& direction() const { return m_direction; }
    void set(const std::optional<glm::dvec3>& direction)
    {
        if (direction == m_direction)
            return;
        m_direction = direction;
        emit moved();
    }

signals:
    void moved();

private:
    std::optional<glm::dvec3> m_direction;
};

} // namespace mirrorball::studio
