#include "layout_detection.h"

#include "ball_finder.h"
#include "cube_sheet.h"
#include "paraboloid_halves.h"
#include "reproject.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

std::string sizeText(const ImageFileInfo& info) { return std::to_string(info.width) + " x " + std::to_string(info.height); }

struct KnownSheet {
    CubeSheet sheet;
    Arrangement arrangement;
    const char* description;
};
constexpr std::array<KnownSheet, 6> sheets{{{CubeSheet::Stack, Arrangement::Whole, "1:6, six cube faces stacked"},
                                            {CubeSheet::Strip, Arrangement::HorizontalStrip, "6:1, six cube faces in a row"},
                                            {CubeSheet::Grid3x2, Arrangement::Grid3x2, "3:2, cube faces in two rows"},
                                            {CubeSheet::Grid2x3, Arrangement::Grid2x3, "2:3, cube faces in three rows"},
                                            {CubeSheet::HorizontalCross, Arrangement::HorizontalCross, "4:3, a horizontal cross"},
                                            {CubeSheet::VerticalCross, Arrangement::VerticalCross, "3:4, a vertical cross"}}};

/// The sheet that an arrangement is; nothing where it is none.
std::optional<CubeSheet> sheetOf(const Detection& detection)
{
    if (detection.arrangement == Arrangement::BorderedFaces)
        return CubeSheet::Stack;
    if (detection.layout.kind == Parameterization::Cube)
        for (const KnownSheet& known : sheets)
            if (known.arrangement == detection.arrangement)
                return known.sheet;
    return std::nullopt;
}

/// Whether the texels are of a kind that photographs come in.
bool isPhotographic(const ImageFileInfo& info) { return info.sampleType.starts_with("uint"); }

std::optional<Detection> asCube(const ImageFileInfo& info)
{
    for (const KnownSheet& known : sheets) {
        const glm::ivec2 cells = cellsOf(known.sheet);
        if (info.width % cells.x != 0 || info.height % cells.y != 0 || info.width / cells.x != info.height / cells.y)
            continue;
        Detection found{{Parameterization::Cube, info.width / cells.x, 0}, known.arrangement, known.description, true};
        if (isPhotographic(info) && known.sheet != CubeSheet::Stack && known.sheet != CubeSheet::Strip) {
            found.reason += "; a photograph may have this shape, too (a mirror ball: --from sphere --fit crop)";
            found.certain = false;
        }
        return found;
    }
    return {};
}

/// The sizes that a kind comes in, for messages.
std::string sizesOf(Parameterization kind)
{
    const Mapping& row = mapping(kind);
    switch (row.charts) {
    case Charts::Faces:
        return "N x 6N, 6N x N, 3N x 2N, 2N x 3N, a cross of 4N x 3N or one of 3N x 4N";
    case Charts::Halves:
        return "2N x N, the two halves side by side";
    case Charts::Whole:
    case Charts::Disc:
        break;
    }
    return std::string(row.columns == 2 ? "2N x N" : "N x N") + ", or an option --fit";
}

/// An image of this size as a map of this kind, if it can be one.
std::optional<Detection> asKind(const ImageFileInfo& info, Parameterization kind, int border)
{
    if (info.width == 1 && info.height == 1)
        return Detection{{kind, 1, 0}, Arrangement::Constant, {}, true};
    if (kind == Parameterization::Cube && border > 0 && info.height == 6 * info.width && info.width > 2 * border)
        return Detection{.layout = {kind, info.width - 2 * border, 0}, .arrangement = Arrangement::BorderedFaces, .faceBorder = border};
    if (kind == Parameterization::Cube)
        return asCube(info);
    const MapLayout layout{kind, info.height, border};
    if (layout.width() != info.width || border < 0 || (border > 0 && 2 * border >= info.height))
        return {};
    return Detection{layout, Arrangement::Whole, {}, true};
}

std::optional<Detection> fromEnvmapAttribute(const ImageFileInfo& info)
{
    if (info.envmap == "latlong" && info.width >= 2 && info.height >= 2)
        return Detection{
            {Parameterization::Latlong, info.height, 0}, Arrangement::EdgeSampledLatlong, "OpenEXR envmap latlong", true, true};
    if (info.envmap == "cube" && info.width >= 2 && info.height == 6 * info.width)
        return Detection{{Parameterization::Cube, info.width, 0}, Arrangement::OpenExrCube, "OpenEXR envmap cube", true, true};
    return {};
}

std::optional<Detection> fromOwnAttributes(const ImageFileInfo& info)
{
    const auto found = info.attributes.find("mirrorball:parameterization");
    if (found == info.attributes.end())
        return {};
    const auto kind = parameterizationFromName(found->second);
    if (!kind)
        return {};
    const bool hasBorder = mapping(*kind).hasBorder || *kind == Parameterization::Cube;
    auto detection = asKind(info, *kind, hasBorder ? borderOf(info) : 0);
    if (detection) {
        detection->reason = "the file says " + found->second;
        detection->certain = detection->said = true;
    }
    return detection;
}

/// By what the file says and by its shape, if that is a map's own.
std::optional<Detection> known(const ImageFileInfo& info, std::optional<Parameterization> forced)
{
    const auto fromFile = fromEnvmapAttribute(info);
    const auto own = fromOwnAttributes(info);
    if (forced) {
        if (fromFile && fromFile->layout.kind == *forced)
            return fromFile;
        auto detection = own && own->layout.kind == *forced ? own : asKind(info, *forced, 0);
        if (detection) {
            detection->reason = "read as " + std::string(name(*forced)) + " on request";
            detection->certain = true;
        }
        return detection;
    }
    if (fromFile)
        return fromFile;
    if (own)
        return own;
    if (info.width == 1 && info.height == 1)
        return Detection{{Parameterization::Latlong, 1, 0}, Arrangement::Constant, "a single texel, the same in every direction", true};
    if (info.width == 2 * info.height)
        return Detection{{Parameterization::Latlong, info.height, 0}, Arrangement::Whole, "2:1, taken for a latlong", true};
    if (info.width == info.height)
        return Detection{{Parameterization::Angular, info.width, 0},
                         Arrangement::Whole,
                         "a square, taken for an angular map; it may as well be sphere or octahedral",
                         false};
    return asCube(info);
}

bool isAlmostTwice(const ImageFileInfo& info) { return std::abs(info.width - 2.0 * info.height) <= 0.05 * 2.0 * info.height; }

std::string angleText(const ViewOnSphere& view)
{
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.4g x %.4g degrees", view.horizontalDeg, view.verticalDeg);
    return text.data();
}

void noteBlack(Detection& detection, std::int64_t black)
{
    const std::int64_t all = std::int64_t{detection.layout.width()} * detection.layout.height();
    if (black > 0)
        detection.notes.push_back(std::to_string(black) + " of " + std::to_string(all) + " texels lie outside the picture and are black");
}

/// @throws FileError for a map that would be larger than any file may be
void checkFitted(const ImageFileInfo& info, double size)
{
    if (!(size <= 8192.0))
        throw FileError(info.path.string(), "a map of the whole sphere would need " + std::to_string(static_cast<long long>(size)) +
                                                " rows at these angles of view; at most 8192 are made, give wider ones");
}

Detection partialLatlong(const ImageFileInfo& info, const ProbeReading& reading)
{
    Detection found{.arrangement = Arrangement::Partial};
    found.view = latlongView(info.width, info.height, reading);
    checkFitted(info, std::max(180.0 * info.width / found.view.horizontalDeg, 180.0 * info.height / found.view.verticalDeg));
    found.layout = {Parameterization::Latlong, latlongSize(info.width, info.height, found.view), 0};
    found.reason = sizeText(info) + ", a part of a latlong on request: " + angleText(found.view);
    noteBlack(found, blackTexelsOnLatlong(found.view, found.layout.size));
    return found;
}

Detection fisheye(const ImageFileInfo& info, const ProbeReading& reading)
{
    if (info.width != info.height)
        throw FileError(info.path.string(),
                        "a fisheye's picture must be square, its disc inscribed; this has " + sizeText(info) + " texels");
    Detection found{.arrangement = Arrangement::Partial};
    const double angle = reading.horizontalAngleDeg > 0.0 ? reading.horizontalAngleDeg : reading.verticalAngleDeg;
    found.view = {angle, angle, reading.beyond};
    checkFitted(info, info.width * 360.0 / angle);
    found.layout = {Parameterization::Angular, static_cast<int>(std::lround(info.width * 360.0 / angle)), 0};
    found.reason = "a fisheye's picture on request: " + angleText(found.view);
    noteBlack(found, blackTexelsOnAngularMap(found.view, found.layout.size));
    return found;
}

/// What the options make of a picture whose shape is no map's, or that is to be read otherwise. Nothing where they say nothing.
std::optional<Detection> fitted(const ImageFileInfo& info, const ProbeReading& reading)
{
    const bool hasAngles = reading.horizontalAngleDeg > 0.0 || reading.verticalAngleDeg > 0.0;
    const Parameterization kind = reading.parameterization.value_or(Parameterization::Latlong);
    if (hasAngles && kind == Parameterization::Latlong)
        return partialLatlong(info, reading);
    if (hasAngles && kind == Parameterization::Angular)
        return fisheye(info, reading);
    if (hasAngles)
        throw InvalidArgument("horizontal_angle: belongs to latlong and angular, not to " + std::string(name(kind)));
    if (kind == Parameterization::Sphere && reading.fit == Fit::Crop)
        return Detection{{kind, squareSize(info.width, info.height, Fit::Crop), 0},
                         Arrangement::Ball,
                         "a photographed mirror ball on request, cropped to its outline",
                         true};
    auto exact = known(info, reading.parameterization);
    if (exact)
        return exact;
    if (reading.fit != Fit::None && kind == Parameterization::Latlong)
        return partialLatlong(info, reading);
    if (reading.fit != Fit::None && mapping(kind).chartCount() > 1)
        throw InvalidArgument("fit: belongs to latlong, sphere, angular and octahedral, not to " + std::string(name(kind)));
    if (reading.fit != Fit::None) {
        Detection found{{kind, squareSize(info.width, info.height, reading.fit), 0}, Arrangement::NotSquare};
        found.fit = reading.fit;
        found.reason = sizeText(info) + ", made square on request";
        return found;
    }
    if (kind != Parameterization::Latlong || !isAlmostTwice(info))
        return std::nullopt;
    ProbeReading stretched = reading;
    stretched.fit = Fit::Stretch;
    Detection found = partialLatlong(info, stretched);
    found.reason = sizeText(info) + ", almost 2:1, stretched to a latlong";
    found.certain = false;
    found.notes.push_back(sizeText(info) + " texels are almost 2:1 and stretched to a latlong; --fit pad or crop reads it otherwise");
    return found;
}

Assumption handedness(const Detection& found)
{
    static const std::string mirrored = "mirrored: --mirror x";
    const char* shape = "the convention for this arrangement";
    switch (found.arrangement) {
    case Arrangement::EdgeSampledLatlong:
    case Arrangement::OpenExrCube:
        return {"handedness", "as OpenEXR defines it", "the envmap attribute"};
    case Arrangement::HorizontalCross:
    case Arrangement::VerticalCross:
        return {"handedness", "a picture from inside: +Z in front, -X at its right", shape, Certainty::Likely, {mirrored}};
    default:
        break;
    }
    Assumption result{"handedness", std::string(mapping(found.layout.kind).seen), shape, Certainty::Likely, {mirrored}};
    if (found.layout.kind == Parameterization::Cube)
        result.others.push_back("another order or turn: --faces");
    return result;
}

void finish(Detection& found, const ImageFileInfo& info, const ProbeReading& reading)
{
    const bool asked = reading.parameterization.has_value();
    const Certainty certainty = !found.certain ? Certainty::Guess : asked || found.said ? Certainty::Certain : Certainty::Likely;
    Assumption kind{"parameterization", std::string(name(found.layout.kind)), found.reason, certainty};
    if (!asked && info.width == info.height && !found.said)
        kind.others = {"sphere (a photographed mirror ball: --from sphere --fit crop)", "octahedral"};
    else if (!asked && info.width == 2 * info.height && !found.said)
        kind.others = {"paraboloid"};
    else if (found.arrangement == Arrangement::Partial && !found.certain)
        kind.others = {"padded: --fit pad", "cropped: --fit crop"};
    else if (!found.certain)
        kind.others = {"sphere (a photographed mirror ball: --from sphere --fit crop)", "a partial panorama: --fit pad"};
    found.assumed.push_back(std::move(kind));

    checkFaceOrder(reading.faces);
    if (!reading.faces.empty() && !sheetOf(found))
        throw InvalidArgument("faces: belongs to cubes whose faces lie on a sheet or in six files, not to this file: " + found.reason);
    found.faces = reading.faces;
    Assumption hand = handedness(found);
    const auto known = std::find_if(info.assumed.begin(), info.assumed.end(), [](const Assumption& a) { return a.topic == "handedness"; });
    if (!reading.faces.empty())
        hand = {"handedness", "faces " + reading.faces, "asked for"};
    else if (known != info.assumed.end() && found.said)
        hand = *known;
    else if (found.said && info.envmap.empty())
        hand = {"handedness", hand.value, "Mirrorball wrote it"};
    if (reading.mirror != MirrorAxis::None)
        hand = {"handedness", hand.value + ", mirrored in " + std::string(wordOf(reading.mirror)), "asked for"};
    found.assumed.push_back(std::move(hand));
    found.orientation = orientation(reading);
}

/// The size that an image must have.
glm::ivec2 expectedSize(const Detection& detection)
{
    if (const auto sheet = sheetOf(detection))
        return cellsOf(*sheet) * (detection.layout.size + 2 * detection.faceBorder);
    if (detection.arrangement == Arrangement::Constant)
        return {1, 1};
    return {detection.layout.width(), detection.layout.height()};
}

EnvironmentMap spread(const MapLayout& layout, const float* texel)
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            std::copy_n(texel, 3, map.image.texel(x, y));
    return map;
}

/// The map before it is turned.
EnvironmentMap arranged(Image image, const Detection& detection, const JobControl& job)
{
    const MapLayout& layout = detection.layout;
    switch (detection.arrangement) {
    case Arrangement::EdgeSampledLatlong:
        return fromEdgeSampledLatlong(image, job);
    case Arrangement::OpenExrCube:
        return fromOpenExrCube(image, job);
    case Arrangement::Partial:
        return {layout, layout.kind == Parameterization::Latlong ? onLatlong(image, detection.view, layout.size, job)
                                                                 : onAngularMap(image, detection.view, layout.size, job)};
    case Arrangement::NotSquare:
        return {layout, squared(image, detection.fit, layout.size, job)};
    case Arrangement::Ball: {
        const auto ball = findBall(image);
        return {layout, ball ? around(image, *ball, layout.size, job) : squared(image, Fit::Crop, layout.size, job)};
    }
    default:
        break;
    }
    const glm::ivec2 expected = expectedSize(detection);
    if (image.width != expected.x || image.height != expected.y || image.channels != 3)
        throw InvalidArgument("the image has " + std::to_string(image.width) + " x " + std::to_string(image.height) + " texels of " +
                              std::to_string(image.channels) + " channels where its header promised " + std::to_string(expected.x) + " x " +
                              std::to_string(expected.y) + " of 3");
    if (detection.arrangement == Arrangement::Constant)
        return spread(layout, image.texels.data());
    const auto sheet = sheetOf(detection);
    if (sheet && (detection.arrangement != Arrangement::Whole || !detection.faces.empty()))
        return cutUp(image, *sheet, detection.faceBorder, detection.faces);
    return {layout, std::move(image)};
}

} // namespace

Detection detectLayout(const ImageFileInfo& info, const ProbeReading& reading)
{
    if (info.width < 1 || info.height < 1)
        throw FileError(info.path.string(), "an image of " + sizeText(info) + " texels holds no map");
    auto found = fitted(info, reading);
    if (found) {
        finish(*found, info, reading);
        return std::move(*found);
    }
    if (reading.parameterization)
        throw FileError(info.path.string(), "an image of " + sizeText(info) + " texels is no " +
                                                std::string(name(*reading.parameterization)) + " map: that needs " +
                                                sizesOf(*reading.parameterization));
    throw FileError(info.path.string(),
                    "an image of " + sizeText(info) +
                        " texels fits no map: a latlong or paraboloid is 2N x N, a sphere, angular or octahedral map N "
                        "x N, a cube " +
                        sizesOf(Parameterization::Cube) +
                        "; a partial panorama is read with --fit pad, another with --fit stretch or crop, a photographed "
                        "mirror ball with --from sphere --fit crop");
}

Detection detectLayout(const ImageFileInfo& info, std::optional<Parameterization> forced)
{
    return detectLayout(info, ProbeReading{.parameterization = forced});
}

EnvironmentMap toEnvironmentMap(Image image, const Detection& detection, const JobControl& job)
{
    EnvironmentMap map = arranged(std::move(image), detection, job);
    if (detection.orientation == glm::dmat3(1.0))
        return map;
    return reproject(map, {.target = map.layout, .turn = detection.orientation}, job);
}

} // namespace mirrorball
