#include "builtin_probes.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>

namespace mirrorball {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double rad(double degrees) { return degrees * pi / 180.0; }

double smoothStep(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// ---------------------------------------------------------------------------------------------------------------- studio

/// A flat lamp or a black card that faces the object at the origin.
struct Panel {
    dvec3 towards;     ///< unit direction of its center
    double distance;   ///< of its center
    dvec3 right, up;   ///< unit axes of the panel; `right` is horizontal
    dvec2 half;        ///< half its width and height
    double edge;       ///< width of the falloff inside its edge
    double frame;      ///< width of the black frame around it
    dvec3 color;       ///< radiance at the center of the cloth
    double rim;        ///< share of that which is left in the corners
    double flash;      ///< radiance of the tube that shines through the cloth
    double flashWidth; ///< its standard deviation
    double reach;      ///< cosine of the angle about the center beyond which the panel is not seen
};

Panel panel(double lonDeg, double latDeg, double distance, dvec2 half, double edge, double frame, dvec3 color, double rim,
            double flash = 0.0, double flashWidth = 1.0)
{
    const dvec3 towards = directionFromLonLat(rad(lonDeg), rad(latDeg));
    // Horizontal and perpendicular to the line of sight; the overhead panel keeps its longitude's orientation.
    const dvec3 right = directionFromLonLat(rad(lonDeg) - pi / 2, 0.0);
    const dvec3 up = glm::cross(right, towards);
    const double extent = glm::length(half + dvec2(frame));
    return {towards, distance, right, up, half, edge, frame, color, rim, flash, flashWidth, std::cos(std::atan2(extent, distance))};
}

const std::array studioPanels{
    // Key: a large soft box up at the camera's left, its tube glowing through the cloth.
    panel(-46, 38, 3.0, {0.95, 1.15}, 0.06, 0.05, {8.2, 7.9, 7.4}, 0.30, 340.0, 0.055),
    // Strip: a narrow warm-to-neutral line down the camera's right.
    panel(62, 14, 2.8, {0.16, 1.55}, 0.05, 0.03, {15.0, 15.2, 15.6}, 0.45),
    // Overhead box, the long highlight on lids and shoulders.
    panel(170, 72, 2.8, {1.05, 0.42}, 0.08, 0.04, {5.2, 5.3, 5.5}, 0.40),
    // Rim light behind on the right, cool.
    panel(140, 24, 3.0, {0.42, 0.95}, 0.05, 0.03, {8.6, 9.6, 11.0}, 0.35),
    // Fill: a large dim reflector behind on the left, warm.
    panel(-122, 8, 3.0, {0.85, 1.25}, 0.16, 0.02, {1.55, 1.42, 1.25}, 0.55),
    // Black cards, which give metal its dark edges.
    panel(36, 6, 2.8, {0.30, 1.30}, 0.10, 0.0, {0.02, 0.02, 0.02}, 1.0),
    panel(-88, 2, 3.0, {0.24, 1.20}, 0.10, 0.0, {0.02, 0.02, 0.02}, 1.0),
};

/// The room without its lamps: a floor that sweeps up into the wall, a lit backdrop at -Z, a dark ceiling.
dvec3 studioRoom(const dvec3& d)
{
    const double toBackdrop = std::max(-d.z, 0.0);
    const double wall = 0.11 + 0.42 * toBackdrop * toBackdrop * std::exp(-7.0 * (d.y - 0.04) * (d.y - 0.04));
    const double ceiling = 0.035;
    const dvec3 above = glm::mix(wall * dvec3(0.97, 0.99, 1.04), ceiling * dvec3(0.95, 0.98, 1.08), smoothStep(0.05, 0.95, d.y));
    if (d.y >= 0.0)
        return above;
    // The floor lies one unit below the object; the key light pools on it around the object's feet.
    const double h = std::max(-d.y, 0.02);
    const dvec2 p(d.x / h, d.z / h);
    const double pool = 1.0 / (1.0 + 0.16 * glm::dot(p - dvec2(0.5, -0.7), p - dvec2(0.5, -0.7)));
    const double underObject = 1.0 - 0.55 * std::exp(-1.6 * glm::dot(p, p));
    const dvec3 floor = (0.07 + 0.25 * pool) * underObject * dvec3(1.03, 1.0, 0.96);
    return glm::mix(above, floor, smoothStep(0.02, 0.42, -d.y));
}

dvec3 studioRadiance(const dvec3& d)
{
    dvec3 radiance = studioRoom(d);
    for (const Panel& p : studioPanels) {
        const double cosine = glm::dot(d, p.towards);
        if (cosine < p.reach)
            continue;
        // The plane through the center, perpendicular to the line of sight: d reaches it at t d.
        const dvec3 onPlane = d * (p.distance / cosine);
        const dvec2 q(glm::dot(onPlane, p.right), glm::dot(onPlane, p.up));
        const double corner = 0.25 * std::min(p.half.x, p.half.y);
        const dvec2 outside = glm::abs(q) - p.half + corner;
        const double sd = glm::length(glm::max(outside, 0.0)) + std::min(std::max(outside.x, outside.y), 0.0) - corner;
        if (sd >= p.frame)
            continue;
        if (sd >= 0.0) {
            radiance = dvec3(0.012);
            continue;
        }
        const dvec2 s = q / p.half;
        const double cloth = p.rim + (1.0 - p.rim) * std::exp(-1.1 * glm::dot(s, s));
        const double flash = p.flash * std::exp(-0.5 * glm::dot(q, q) / (p.flashWidth * p.flashWidth));
        const double in = smoothStep(0.0, p.edge, -sd);
        const dvec3 lamp = p.color * cloth + flash * dvec3(1.0, 0.97, 0.92);
        radiance = p.frame > 0.0 ? in * lamp : glm::mix(radiance, lamp, in);
    }
    return radiance;
}

// ------------------------------------------------------------------------------------------------------------------- sky

// Daylight after A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999. Luminance Y (in
// kcd/m^2) and chromaticities x, y of the sky follow the five-parameter distribution of Perez et al. 1993 (Preetham's eq. 3),
//   F(theta, gamma) = (1 + A e^(B / cos theta)) (1 + C e^(D gamma) + E cos^2 gamma),
// relative to the zenith (eq. 4): Y = Y_z F(theta, gamma) / F(0, theta_s), and x and y alike. theta is the angle from the zenith,
// gamma the angle from the sun, theta_s the sun's angle from the zenith. The coefficients, linear in the turbidity T, and the zenith
// values are those of the paper's appendix A.2.
//
// The sun. Outside the atmosphere it gives 133 klx (Darula, Kittler, Gueymard 2005) with the color of a 5778 K black body, in
// Rec.709 (1.113, 0.975, 0.912) for luminance 1. On its way down it is dimmed by air molecules, aerosol and ozone (appendix A.1):
//   exp(-m (0.008735 w^-4.08 + beta w^-1.3 + 0.35 k_o)),   beta = 0.04608 T - 0.04586,
//   m = 1 / (cos theta_s + 0.15 (93.885 - theta_s in degrees)^-1.253),
// with w the wavelength in micrometres and k_o ozone's coefficient; here at 0.611, 0.549 and 0.464, the dominant wavelengths of
// Rec.709's primaries. For T = 2.5 at an elevation of 35 degrees m = 1.739 and (0.660, 0.612, 0.507) of R, G, B are left: 82 klx.
// Over the disc's solid angle 2 pi (1 - cos 0.2665 deg) = 6.797e-5 sr that is a luminance of 1.21e6 kcd/m^2. The zenith has
// 4.8 kcd/m^2: the ratio is 250 000. One unit of ours is 10 kcd/m^2, so the zenith is 0.48, the sun 1.2e5, a white card 1.9.

constexpr double skyTurbidity = 2.5;
constexpr double sunElevation = rad(35.0);
constexpr double sunLongitude = rad(40.0);
constexpr double kcdPerUnit = 10.0;

struct Perez {
    double a, b, c, d, e;
    double operator()(double cosTheta, double gamma, double cosGamma) const
    {
        return (1.0 + a * std::exp(b / cosTheta)) * (1.0 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// Everything about the sky that does not depend on the direction.
struct Sky {
    dvec3 sun{}; ///< direction
    dvec3 sunRadiance{};
    Perez luminance{}, x{}, y{};
    dvec3 scale{};  ///< zenith value over F(0, theta_s): luminance, x, y
    dvec3 ground{}; ///< radiance of the lit ground

    Sky();
    dvec3 radianceAbove(const dvec3& d) const;
};

Sky::Sky()
{
    constexpr double t = skyTurbidity;
    constexpr double s = pi / 2 - sunElevation; // theta_s
    sun = directionFromLonLat(sunLongitude, sunElevation);

    luminance = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
    x = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
    y = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * s);
    const double zenithLuminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    const double zenithX = t * t * (0.00166 * s * s * s - 0.00375 * s * s + 0.00209 * s) +
                           t * (-0.02903 * s * s * s + 0.06377 * s * s - 0.03202 * s + 0.00394) +
                           (0.11693 * s * s * s - 0.21196 * s * s + 0.06052 * s + 0.25886);
    const double zenithY = t * t * (0.00275 * s * s * s - 0.00610 * s * s + 0.00317 * s) +
                           t * (-0.04214 * s * s * s + 0.08970 * s * s - 0.04153 * s + 0.00516) +
                           (0.15346 * s * s * s - 0.26756 * s * s + 0.06670 * s + 0.26688);
    const double c = std::cos(s);
    scale = {zenithLuminance / kcdPerUnit / luminance(1.0, s, c), zenithX / x(1.0, s, c), zenithY / y(1.0, s, c)};

    const double beta = 0.04608 * t - 0.04586;
    const double airMass = 1.0 / (c + 0.15 * std::pow(93.885 - s * 180.0 / pi, -1.253));
    const dvec3 wavelength(0.611, 0.549, 0.464), ozone(0.120, 0.085, 0.007), outside = 133.0 * dvec3(1.113, 0.975, 0.912);
    const double solidAngle = 2.0 * pi * (1.0 - std::cos(skySunRadius));
    for (int i = 0; i < 3; ++i) {
        const double depth = 0.008735 * std::pow(wavelength[i], -4.08) + beta * std::pow(wavelength[i], -1.3) + 0.35 * ozone[i];
        sunRadiance[i] = outside[i] * std::exp(-airMass * depth) / solidAngle / kcdPerUnit;
    }

    // The ground is a diffuse plane: radiance = albedo / pi times the irradiance of sun and sky, the latter by the midpoint rule.
    dvec3 irradiance = sunRadiance * solidAngle * sun.y;
    constexpr int rows = 24, columns = 48;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double sinLat = (i + 0.5) / rows;
            irradiance += radianceAbove(directionFromLonLat((j + 0.5) * 2.0 * pi / columns, std::asin(sinLat))) * sinLat *
                          (2.0 * pi / (rows * columns));
        }
    ground = dvec3(0.150, 0.152, 0.105) * irradiance / pi;
}

/// The sky's own radiance, without the sun's disc; d.y >= 0.
dvec3 Sky::radianceAbove(const dvec3& d) const
{
    const double cosTheta = std::max(d.y, 1e-3); // e^(B / cos theta) has gone to 0 by then
    const double cosGamma = std::clamp(glm::dot(d, sun), -1.0, 1.0);
    const double gamma = std::acos(cosGamma);
    const double bigY = scale[0] * luminance(cosTheta, gamma, cosGamma);
    const double cx = scale[1] * x(cosTheta, gamma, cosGamma);
    const double cy = scale[2] * y(cosTheta, gamma, cosGamma);
    const double bigX = bigY * cx / cy, bigZ = bigY * (1.0 - cx - cy) / cy;
    // XYZ to linear Rec.709 (D65). Source: IEC 61966-2-1:1999, section 5.2.
    return glm::max(dvec3(3.2406 * bigX - 1.5372 * bigY - 0.4986 * bigZ, -0.9689 * bigX + 1.8758 * bigY + 0.0415 * bigZ,
                          0.0557 * bigX - 0.2040 * bigY + 1.0570 * bigZ),
                    0.0);
}

const Sky& sky()
{
    static const Sky theSky;
    return theSky;
}

/// Sky and ground. Below the horizon the haze in front of the ground thins with the depth of the view, so the two meet softly.
dvec3 skyWithoutSun(const dvec3& d)
{
    const Sky& s = sky();
    if (d.y >= 0.0)
        return s.radianceAbove(d);
    const double haze = std::exp(d.y / 0.035);
    if (haze < 1e-6)
        return s.ground;
    const dvec3 horizon(d.x, 0.0, d.z);
    return glm::mix(s.ground, s.radianceAbove(glm::normalize(horizon)), haze);
}

dvec3 skyRadiance(const dvec3& d)
{
    const dvec3 own = skyWithoutSun(d);
    // The chord 2 sin(r/2) tells the tiny angle better than the cosine does.
    const bool inDisc = glm::length(d - sky().sun) <= 2.0 * std::sin(0.5 * skySunRadius);
    return inDisc ? own + sky().sunRadiance : own;
}

// ------------------------------------------------------------------------------------------------------- cube room, axes

/// A face of the cube as an observer at its center sees it.
struct Face {
    dvec3 forward, right, up;
};

/// +X -X +Y -Y +Z -Z; right = forward x up, the handedness of space.
const std::array<Face, 6> faces = [] {
    const std::array<std::array<dvec3, 2>, 6> forwardUp{{{dvec3(1, 0, 0), dvec3(0, 1, 0)},
                                                         {dvec3(-1, 0, 0), dvec3(0, 1, 0)},
                                                         {dvec3(0, 1, 0), dvec3(0, 0, -1)},
                                                         {dvec3(0, -1, 0), dvec3(0, 0, 1)},
                                                         {dvec3(0, 0, 1), dvec3(0, 1, 0)},
                                                         {dvec3(0, 0, -1), dvec3(0, 1, 0)}}};
    std::array<Face, 6> result;
    for (size_t i = 0; i < 6; ++i)
        result[i] = {forwardUp[i][0], glm::cross(forwardUp[i][0], forwardUp[i][1]), forwardUp[i][1]};
    return result;
}();

/// The face that d points at: 0 .. 5 for +X -X +Y -Y +Z -Z.
int faceOf(const dvec3& d)
{
    const dvec3 a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return 2 * axis + (d[axis] < 0.0 ? 1 : 0);
}

/// Where d meets the face, right and up, each in [-1, 1].
dvec2 onFace(const Face& face, const dvec3& d) { return dvec2(glm::dot(d, face.right), glm::dot(d, face.up)) / glm::dot(d, face.forward); }

/// 1 + amount or 1 - amount on the squares of an 8 x 8 board.
double checker(const dvec2& p, double amount)
{
    const int square = static_cast<int>(std::floor(4.0 * p.x)) + static_cast<int>(std::floor(4.0 * p.y));
    return square % 2 == 0 ? 1.0 + amount : 1.0 - amount;
}

dvec3 cubeRoomRadiance(const dvec3& d)
{
    // Red, green, white, violet, yellow, blue, with luminances 0.16 0.28 0.87 0.05 0.50 0.09.
    static constexpr std::array<dvec3, 6> walls{dvec3(0.58, 0.045, 0.06), dvec3(0.06, 0.36, 0.08), dvec3(0.88, 0.87, 0.82),
                                                dvec3(0.12, 0.02, 0.14),  dvec3(0.72, 0.48, 0.03), dvec3(0.03, 0.07, 0.45)};
    const int face = faceOf(d);
    const dvec2 p = onFace(faces[static_cast<size_t>(face)], d);
    constexpr double line = 0.018; // half the width of the dark line that two walls share
    if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0 - line)
        return dvec3(0.012);
    return walls[static_cast<size_t>(face)] * checker(p, 0.11);
}

/// Squared distance from p to the segment ab.
double toSegment(const dvec2& p, const dvec2& a, const dvec2& b)
{
    const dvec2 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    const dvec2 gap = p - a - t * ab;
    return glm::dot(gap, gap);
}

/// Distance from p to the strokes of an axis name ("+X" ... "-Z") of height 1, centered at the origin: the sign stands left of the
/// letter, so a mirrored name is wrong at once even though X and Y mirror into themselves. The strokes lie in |x| < 0.8, |y| <= 0.5.
double toAxisName(const dvec2& p, int axis)
{
    const auto stroke = [&](double x0, double y0, double x1, double y1) { return toSegment(p, {x0, y0}, {x1, y1}); };
    double squared = stroke(-0.78, 0.0, -0.26, 0.0);
    if (axis % 2 == 0)
        squared = std::min(squared, stroke(-0.52, -0.26, -0.52, 0.26));
    constexpr double left = 0.02, right = 0.72, center = 0.37;
    switch (axis / 2) {
    case 0:
        squared = std::min({squared, stroke(left, 0.5, right, -0.5), stroke(left, -0.5, right, 0.5)});
        break;
    case 1:
        squared =
            std::min({squared, stroke(left, 0.5, center, 0.02), stroke(right, 0.5, center, 0.02), stroke(center, 0.02, center, -0.5)});
        break;
    default:
        squared = std::min({squared, stroke(left, 0.5, right, 0.5), stroke(right, 0.5, left, -0.5), stroke(left, -0.5, right, -0.5)});
    }
    return std::sqrt(squared);
}

dvec3 axesRadiance(const dvec3& d)
{
    static constexpr std::array<dvec3, 6> colors{dvec3(0.62, 0.05, 0.04), dvec3(0.04, 0.42, 0.46), dvec3(0.10, 0.40, 0.06),
                                                 dvec3(0.46, 0.06, 0.36), dvec3(0.05, 0.11, 0.62), dvec3(0.72, 0.50, 0.04)};
    const dvec3 white(0.95), ink(0.012);
    const int index = faceOf(d);
    const Face& face = faces[static_cast<size_t>(index)];
    const dvec2 p = onFace(face, d);
    const double edge = std::max(std::abs(p.x), std::abs(p.y));
    if (edge > 0.985)
        return ink;
    if (p.x + p.y > 1.72)
        return p.x + p.y > 1.75 ? white : ink;

    // Signed distances to all that is drawn in white; each drawing has a dark outline of its own.
    double distance = 1.0, outline = 0.030;
    if (std::abs(p.x) < 0.70 && std::abs(p.y) < 0.47) // the big name
        distance = toAxisName(p / 0.74, index) * 0.74 - 0.055;
    if (std::abs(p.x) < 0.12 && p.y > 0.46 && p.y < 0.74) { // the arrow to the upper edge
        const double squared = std::min(
            {toSegment(p, {0.0, 0.50}, {0.0, 0.70}), toSegment(p, {0.0, 0.70}, {-0.08, 0.60}), toSegment(p, {0.0, 0.70}, {0.08, 0.60})});
        const double arrow = std::sqrt(squared) - 0.018;
        if (arrow < distance) {
            distance = arrow;
            outline = 0.016;
        }
    }
    if (edge > 0.66) { // the neighbor's name inside each edge
        const bool sideways = std::abs(p.x) > std::abs(p.y);
        const dvec3 neighbor = sideways ? face.right * (p.x < 0 ? -1.0 : 1.0) : face.up * (p.y < 0 ? -1.0 : 1.0);
        const dvec2 place = sideways ? dvec2(p.x < 0 ? -0.84 : 0.84, 0.0) : dvec2(0.0, p.y < 0 ? -0.87 : 0.87);
        if (std::abs(p.x - place.x) < 0.14 && std::abs(p.y - place.y) < 0.10) {
            const double small = toAxisName((p - place) / 0.14, faceOf(neighbor)) * 0.14 - 0.013;
            if (small < distance) {
                distance = small;
                outline = 0.012;
            }
        }
    }
    if (distance < 0.0)
        return white;
    if (distance < outline)
        return ink;
    return colors[static_cast<size_t>(index)] * checker(p, 0.06);
}

// ------------------------------------------------------------------------------------------------------------- rendering

constexpr std::array probes{
    BuiltinProbe{"studio", "Gray photographic studio with soft boxes, a strip light and a lit backdrop.", studioRadiance},
    BuiltinProbe{"sky", "Clear daylight sky (Preetham 1999) with the sun's disc at 35 degrees over a sunlit ground.", skyRadiance},
    BuiltinProbe{"cube-room", "The inside of a cube with six differently colored, checkered walls.", cubeRoomRadiance},
    BuiltinProbe{"axes", "Test probe whose six cube faces carry the names of their axes.", axesRadiance},
};

using Radiance = dvec3 (*)(const dvec3&);

/// Mean of the radiance over one texel: k x k samples, each weighted by the solid angle per area at its place. A texel of a disc's
/// image that lies off the map has none: its samples count alike.
dvec3 texelMean(Radiance radiance, const MapLayout& layout, int k, int x, int y)
{
    if (k == 1)
        return radiance(texelDirection(layout, x, y));
    const bool inside = isInside(layout, x, y);
    dvec3 sum(0.0);
    double weights = 0.0;
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
            const dvec2 p(x + (i + 0.5) / k, y + (j + 0.5) / k);
            const double w = inside ? density(layout, p) : 1.0;
            if (w <= 0.0)
                continue;
            sum += w * radiance(direction(layout, p));
            weights += w;
        }
    return weights > 0.0 ? sum / weights : radiance(texelDirection(layout, x, y));
}

void store(float* texel, const dvec3& rgb)
{
    for (int c = 0; c < 3; ++c)
        texel[c] = static_cast<float>(rgb[c]);
}

/// How much two texels differ, from 0 to 1; above about 0.04 there is an edge between them.
float contrast(const float* a, const float* b)
{
    float most = 0.0f;
    for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(a[c] - b[c]) / (0.05f + a[c] + b[c]));
    return most;
}

/// Adds a disc of constant radiance by sharing out its solid angle among the texels it falls on, so that sum(L w) is exact however
/// the disc lies to the texels. Points of equal solid angle on a spiral stand for the disc, a thousand or more for each texel.
void splatDisc(EnvironmentMap& map, const dvec3& center, double radius, const dvec3& radiance)
{
    const MapLayout& layout = map.layout;
    const double solidAngle = 2.0 * pi * (1.0 - std::cos(radius));
    const double across = 2.0 * radius / std::sqrt(4.0 * pi / (static_cast<double>(layout.width()) * layout.height()));
    const int points = static_cast<int>(std::clamp(2048.0 * across * across, 32768.0, 4194304.0));

    const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), center));
    const dvec3 up = glm::cross(center, right);
    constexpr double goldenAngle = 2.0 * pi * (2.0 - std::numbers::phi);
    std::unordered_map<size_t, int> hits; // points by texel, y * width + x
    for (int i = 0; i < points; ++i) {
        const double cosine = 1.0 - (1.0 - std::cos(radius)) * (i + 0.5) / points;
        const double sine = std::sqrt(1.0 - cosine * cosine), angle = goldenAngle * i;
        const dvec2 p = coordinate(layout, cosine * center + sine * (std::cos(angle) * right + std::sin(angle) * up));
        const int x = std::clamp(static_cast<int>(p.x), 0, layout.width() - 1);
        const int y = std::clamp(static_cast<int>(p.y), 0, layout.height() - 1);
        ++hits[static_cast<size_t>(y) * static_cast<size_t>(layout.width()) + static_cast<size_t>(x)];
    }
    for (const auto& [index, count] : hits) {
        const int x = static_cast<int>(index % static_cast<size_t>(layout.width()));
        const int y = static_cast<int>(index / static_cast<size_t>(layout.width()));
        const double own = texelSolidAngle(layout, x, y);
        if (own <= 0.0)
            continue; // a rounding away beyond a disc's edge
        const double share = solidAngle * count / points / own;
        float* texel = map.image.texel(x, y);
        for (int c = 0; c < 3; ++c)
            texel[c] = static_cast<float>(texel[c] + share * radiance[c]);
    }
}

} // namespace

std::span<const BuiltinProbe> builtinProbes() { return probes; }

const BuiltinProbe& builtinProbe(std::string_view name)
{
    std::string known;
    for (const BuiltinProbe& probe : probes) {
        if (probe.name == name)
            return probe;
        known += (known.empty() ? "" : ", ") + std::string(probe.name);
    }
    throw InvalidArgument("unknown built-in probe '" + std::string(name) + "'; the built-in probes are " + known);
}

dvec3 skySunDirection() { return sky().sun; }

dvec3 skySunRadiance() { return sky().sunRadiance; }

EnvironmentMap renderBuiltinProbe(std::string_view name, const MapLayout& layout, const JobControl& job)
{
    const BuiltinProbe& probe = builtinProbe(name);
    validate(layout);
    const bool hasSun = probe.radiance == skyRadiance;
    const Radiance radiance = hasSun ? skyWithoutSun : probe.radiance; // a disc of a texel's size would slip between the samples
    EnvironmentMap map(layout);
    const int width = layout.width(), height = layout.height();

    // At least 2^18 samples over the whole map, 0.4 degrees apart, find the smallest detail of any probe.
    const double texels = static_cast<double>(width) * height;
    const int k = std::clamp(static_cast<int>(std::ceil(std::sqrt(262144.0 / texels) - 1e-9)), 1, 512);
    constexpr int edgeK = 3;
    const bool refines = k < edgeK && !hasSun; // the sky has no edges
    JobControl pass = job;
    if (job.progress && refines)
        pass.progress = [&](float f) { job.progress(f / 2.0f); };
    parallelRows(height, pass, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < width; ++x)
                store(map.image.texel(x, y), texelMean(radiance, layout, k, x, y));
    });

    if (refines) {
        const Image coarse = map.image;
        if (job.progress)
            pass.progress = [&](float f) { job.progress(0.5f + f / 2.0f); };
        parallelRows(height, pass, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < width; ++x) {
                    const float* own = coarse.texel(x, y);
                    float most = 0.0f;
                    for (const Texel near : {Texel{x - 1, y}, Texel{x + 1, y}, Texel{x, y - 1}, Texel{x, y + 1}})
                        if (near.x >= 0 && near.x < width && near.y >= 0 && near.y < height)
                            most = std::max(most, contrast(own, coarse.texel(near.x, near.y)));
                    const int fineK = most > 0.2f ? edgeK : most > 0.04f ? 2 : 1; // a faint edge needs fewer samples
                    if (fineK > k)
                        store(map.image.texel(x, y), texelMean(radiance, layout, fineK, x, y));
                }
        });
    }
    if (hasSun)
        splatDisc(map, skySunDirection(), skySunRadius, skySunRadiance());
    return map;
}

} // namespace mirrorball
