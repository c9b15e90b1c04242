#pragma once

#include "core/image/environment_map.h"

#include <string>

/// Small pictures for reports, as the bytes of a .png.
namespace mirrorball {

/// The map as a display shows it, exposed so that its mean is a middle gray: latlong, twice as wide as high.
std::string mapPicture(const EnvironmentMap& map, int height);

/// The exposure that makes a map's mean a middle gray, EV.
double pictureExposure(const EnvironmentMap& map);

/// The map's own texels as a display shows them.
std::string texelPicture(const EnvironmentMap& map, double exposure);

struct ErrorPicture {
    std::string png{};
    double limit = 0.0; ///< what full red (too bright) and full blue (too dark) stand for, over the root mean square of the reference
};

/// The signed error in luminance: red where the map is too bright, blue where too dark, white where it agrees. The limit is the 99.5th
/// percentile of its size, rounded up to 1, 2 or 5 times a power of ten.
/// @param shown  layout of the picture: that of the maps, or one they are resampled to
/// @throws InvalidArgument when the layouts of the maps differ
ErrorPicture errorPicture(const EnvironmentMap& map, const EnvironmentMap& reference, const MapLayout& shown);

/// For the `src` of an image in a page: "data:image/png;base64,...".
std::string dataUri(const std::string& png);

} // namespace mirrorball
