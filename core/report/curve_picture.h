#pragma once

#include "core/image/image.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

/// Lines over one axis as a picture, where there is neither a window system nor a page that would draw them.
namespace mirrorball {

struct Curve {
    std::string label{}; ///< printable ASCII
    glm::vec3 color{0.0f};
    std::vector<glm::dvec2> points{}; ///< ascending in x; y > 0, or left out
};

struct CurvePlot {
    std::string title{}, xTitle{}, yTitle{};
    std::vector<double> xTicks{}; ///< where x is written; the axis spans them and all points
    std::vector<Curve> curves{};
    int width = 640, height = 400; ///< pixels, at least 320 x 200
};

/// The i-th of eight hues that stay apart on white, also for eyes that confuse red and green; after the last the first again.
/// Source: Okabe and Ito 2008
glm::vec3 curveColor(size_t i);

/// y is logarithmic over whole decades, with finer lines at 2 and 5; labels stand at the right in the order of the last points.
/// @return RGB as displayed, 0 to 1: no radiance. @throws InvalidArgument for a smaller size, or without a point
Image curvePicture(const CurvePlot& plot);

} // namespace mirrorball
