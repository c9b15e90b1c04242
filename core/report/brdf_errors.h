#pragma once

#include "core/base/job.h"
#include "core/filter/brdf_lookups.h"
#include "core/filter/lookup_choice.h"
#include "core/image/image.h"

#include <functional>
#include <string>
#include <vector>

/// Of a picture, the error is that of the shading: how far the radiance that lookups give for a surface is from the integral of its BRDF
/// over the probe, by angle of view.
namespace mirrorball {

/// What a BRDF reflects to one view by brute force (brdf_sum.h) in 256 frames: the directions of a latlong map of 16 x 8 as r, each with
/// the normal at two azimuths. Of fewer rows a quarter of the frames for half of them: 64 for a large probe.
class BrdfFrames {
public:
    /// @param latlong  the probe; every texel is summed in every frame. @param rows  of that map, at least 1
    /// @throws InvalidArgument for another layout; Cancelled
    BrdfFrames(const EnvironmentMap& latlong, const Brdf& brdf, double view, const JobControl& job = {}, int rows = 8);

    /// The layout on which a method is asked for the frames of one azimuth.
    const MapLayout& layout() const { return m_layout; }
    /// rel_rms of a method over all frames, weighted by solid angle. @param map  what it gives at an azimuth of the normal
    double relRms(const std::function<EnvironmentMap(double azimuth)>& map) const;

private:
    MapLayout m_layout;
    std::vector<EnvironmentMap> m_truth{}; ///< one an azimuth
};

struct BrdfErrorOptions {
    std::vector<LookupChoice> choices{
        {LookupKind::Fitted, 5}, {LookupKind::Fitted, 3}, {LookupKind::SplitSum}, {LookupKind::Three}, {LookupKind::Filament}};
    std::vector<double> viewsDeg{0.0, 15.0, 30.0, 45.0, 60.0, 75.0}; ///< each in [0, 90)
    int height = 128; ///< texels: the probe is resampled to a latlong of no more rows first; 8 to 1024
};

/// rel_rms by choice of lookups and angle of view.
struct BrdfErrors {
    std::string model{};
    std::vector<double> viewsDeg{};
    std::vector<LookupChoice> choices{};
    std::vector<std::vector<double>> relRms{}; ///< [choice][view]
};

/// Each lookup reads an exactly filtered map: what levels of a chain and their texels miss is not in it.
/// @throws InvalidArgument naming the field that is out of range; Cancelled
BrdfErrors measureBrdfErrors(const EnvironmentMap& probe, const Brdf& brdf, const BrdfErrorOptions& options, const JobControl& job = {});

std::string brdfErrorsText(const BrdfErrors& errors); ///< a table: a row a view, a column a choice
std::string brdfErrorsCsv(const BrdfErrors& errors);  ///< model, lookups, view_degrees, rel_rms
std::string brdfErrorsJson(const BrdfErrors& errors);
/// A line a choice over the angle of view, rel_rms logarithmic: a display picture, RGB.
Image brdfErrorsPicture(const BrdfErrors& errors);

} // namespace mirrorball
