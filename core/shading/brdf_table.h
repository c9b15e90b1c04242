#pragma once

#include "brdf.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <optional>
#include <string>
#include <string_view>

/// A BRDF as tables that a renderer reads.
namespace mirrorball {

enum class BrdfTable {
    Albedo,  ///< "albedo": N x 1, RGB the directional albedo at n.v = (i + 1/2)/N
    Ab,      ///< "ab": N x N, R the scale A and G the bias B of F0 at n.v = (i + 1/2)/N; rows are roughness (j + 1/2)/N, alpha its square
    Fresnel, ///< "fresnel": N x 1, RGB F at the cosine i/(N - 1). Source: 000 section 3.1.1, "a one-dimensional texture"
};

std::optional<BrdfTable> brdfTableFromName(std::string_view name);
std::string brdfTableNames();
/// A line for the command line's help.
std::string brdfTableHelp();

/// The split sum's second factor, with Schlick's F taken apart: the directional albedo is F0 A + B with
///   A = integral K (1 - (1 - h.l)^5),   B = integral K (1 - h.l)^5,   K for F = 1.
/// A + B is the albedo of F = 1. Source: Karis, "Real Shading in Unreal Engine 4", 2013
struct ScaleBias {
    double a = 0.0, b = 0.0;
};
/// @param model  any, with F = 1; its own Fresnel term is left out. @param view radians in [0, pi/2)
ScaleBias scaleAndBias(const BrdfModel& model, double view);

/// @param size  N; 0: 128 (fresnel: 256)
/// @throws InvalidArgument for "ab" of a model that has no roughness, or any Fresnel table of a measurement
Image makeBrdfTable(const Brdf& brdf, BrdfTable table, int size, const JobControl& job = {});

} // namespace mirrorball
