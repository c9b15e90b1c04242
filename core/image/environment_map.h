#pragma once

#include "image.h"

#include "core/sphere/parameterization.h"

#include <glm/glm.hpp>

#include <string>

namespace mirrorball {

/// Radiance by direction: an RGB image and the layout that says what direction each texel stands for. A value.
struct EnvironmentMap {
    MapLayout layout{};
    Image image{}; ///< layout.width() x layout.height(), 3 channels

    EnvironmentMap() = default;
    explicit EnvironmentMap(const MapLayout& layout_) : layout(layout_), image(layout_.width(), layout_.height(), 3) {}
    EnvironmentMap(const MapLayout& layout_, Image image_) : layout(layout_), image(std::move(image_)) {}

    /// Bilinear lookup, seamless: taps over an edge are fetched from the neighboring face or half. d need not be normalized.
    glm::vec3 radiance(const glm::dvec3& d) const;
};

/// Mean radiance over the sphere, weighted by texel solid angle, in double precision.
glm::dvec3 meanRadiance(const EnvironmentMap& map);

} // namespace mirrorball
