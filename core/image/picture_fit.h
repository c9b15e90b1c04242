#pragma once

#include "image.h"
#include "probe_reading.h"

#include "core/base/job.h"

#include <glm/glm.hpp>

#include <cstdint>

/// Pictures whose shape is not that of their map, brought to it.
namespace mirrorball {

/// Where a picture lies on the sphere: about +Z, spanning these angles. More than the sphere has is cut off.
struct ViewOnSphere {
    double horizontalDeg = 360.0;
    double verticalDeg = 180.0;
    BeyondView beyond = BeyondView::Black;
};

/// The angles that a picture of this size spans as part of a latlong, its texels square but for Stretch: Pad shows all of it, Crop as much
/// as the sphere takes. Angles that `reading` gives win; of one of them the other follows.
ViewOnSphere latlongView(int width, int height, const ProbeReading& reading);

/// The height of the latlong whose texels are no coarser than the picture's.
int latlongSize(int width, int height, const ViewOnSphere& view);

/// The latlong of `size` rows that shows the picture: bilinear, around the seam where it spans 360 degrees. Where texels lie on texels, as
/// those of a padded or cropped picture of even width do, they are copied.
Image onLatlong(const Image& picture, const ViewOnSphere& view, int size, const JobControl& job = {});
/// The texels of it that show nothing.
std::int64_t blackTexelsOnLatlong(const ViewOnSphere& view, int size);

/// The angular map, `size` texels an edge, of a fisheye's: radius = angle / half of view.horizontalDeg, the disc inscribed.
Image onAngularMap(const Image& fisheye, const ViewOnSphere& view, int size, const JobControl& job = {});
std::int64_t blackTexelsOnAngularMap(const ViewOnSphere& view, int size);

/// The picture as a square of `size` texels: stretched, padded with black about its middle, or cropped about it.
Image squared(const Image& picture, Fit fit, int size, const JobControl& job = {});
/// The edge of that square.
int squareSize(int width, int height, Fit fit);

/// A circle in a picture, in texels: pixel (x, y) spans x to x + 1.
struct Circle {
    glm::dvec2 center{0.0};
    double radius = 0.0;
};
/// The square around a circle, `size` texels an edge.
Image around(const Image& picture, const Circle& circle, int size, const JobControl& job = {});

} // namespace mirrorball
