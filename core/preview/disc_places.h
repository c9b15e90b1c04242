#pragma once

#include "core/image/image.h"

#include <glm/glm.hpp>

#include <optional>

namespace mirrorball::preview {

/// Where each pixel of a picture looks the painted sphere map up (disc_place.h), kept for a camera that stands still while a pen moves:
/// what the pen touches is then known without drawing anything.
struct DiscPlaces {
    /// Two channels, the place in the disc of radius 1, x to the right, y up. Beside the object: noPlace, twice.
    Image places{};

    static constexpr float noPlace = 4.0f;

    /// The place at (x, y), in pixels from the picture's upper left, linear between the pixels' centers on the same part of the surface;
    /// nothing beside the object and outside the picture.
    std::optional<glm::dvec2> at(double x, double y) const;
};

} // namespace mirrorball::preview
