#pragma once

#include "brdf_stack.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <cstdint>
#include <vector>

namespace mirrorball {

/// What a BRDF reflects of a probe at every angle of view: stacks (brdf_stack.h) at some of them, linear in the angle between,
///   L_o(n, r) = albedo(t) Re sum_m e^(-i m psi) A_m(r; t),
/// t the angle between n and r, psi the azimuth of n about r (reflection_frame.h). The complex maps A_m are latlong, each texel in the
/// frame of its own meridian. In colatitude and longitude A_m is a trigonometric polynomial also across the poles, where it comes back half
/// a turn on with the sign (-1)^m: so ordinary bilinear lookups of such maps have no seam and no pole. Shader twin:
/// resources/shaders/lib/view_stack.glsl.
struct ViewStack {
    struct Node {
        double view = 0.0;  ///< radians
        int orders = 0;     ///< the largest m
        int firstLayer = 0; ///< A_0; then real and imaginary part of A_1, A_2, ...
    };
    static constexpr size_t albedoViews = 64;

    std::vector<Node> nodes{};        ///< from straight on towards the horizon; beyond the last one it holds
    std::vector<glm::dvec3> albedo{}; ///< directional, at albedoViews even angles from 0 to a right one
    std::vector<Image> layers{};      ///< RGB, of one size
    double tolerance = 0.0;           ///< what was asked for, or more where that would have been too large
    double predictedError = 0.0;      ///< rel_rms over all frames at the worst view, from the probe's power by degree
};

struct ViewStackOptions {
    double tolerance = 1e-2; ///< rel_rms, in (0, 1]: of orders and degrees left out, of views and of texels between those that are stored
    double yaw = 0.0;        ///< radians, as yawed()
    std::int64_t mostTexels = std::int64_t{1} << 25; ///< of all layers: narrow lobes that ask for more get a larger tolerance
};

/// A lobe that is narrower than the probe's texels is a lookup times the albedo.
/// @param source  held whole. @throws InvalidArgument for a streamed one; Cancelled
ViewStack makeViewStack(FilterSource& source, const Brdf& brdf, const ViewStackOptions& options = {}, const JobControl& job = {});

/// The light that a surface of normal n reflects, which mirrors the view to r; both of unit length. As the shader reads it.
glm::dvec3 reflected(const ViewStack& stack, const glm::dvec3& n, const glm::dvec3& r);

} // namespace mirrorball
