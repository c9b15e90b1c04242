#include "image_layer.h"

#include "core/spheremap/document/assets.h"
#include "core/spheremap/evaluation/disc_picture.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/picture_fit.h"
#include "core/image/repair.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array passWords{"all"sv, "diffuse"sv, "specular"sv};

struct Passes {
    DiscPicture diffuse{};
    DiscPicture specular{};
};

/// An image without its fourth channel where that says nothing: it reads faster.
Image withoutIdleOpacity(Image rgba)
{
    for (size_t i = 3; i < rgba.texels.size(); i += 4)
        if (rgba.texels[i] < 1.0f)
            return rgba;
    Image rgb(rgba.width, rgba.height, 3);
    for (size_t i = 0; i < rgb.texels.size() / 3; ++i)
        std::copy_n(&rgba.texels[4 * i], 3, &rgb.texels[3 * i]);
    return rgb;
}

Image checked(const std::string& path, Fit fit, Image image)
{
    if (image.width != image.height && fit != Fit::None)
        image = squared(image, fit, squareSize(image.width, image.height, fit));
    if (image.width != image.height)
        throw FileError(path, "is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                  " texels; the picture of a ball must be square, crop it to the ball or set fit to crop");
    repair(image, NegativePolicy::Clamp);
    return withoutIdleOpacity(std::move(image));
}

Passes readPasses(const std::string& path, Fit fit)
{
    Passes passes;
    auto diffuse = readImagePass(path, "diffuse", Channels::ColorAndOpacity),
         specular = readImagePass(path, "specular", Channels::ColorAndOpacity);
    if (!diffuse && !specular)
        diffuse = readImage(path, ProbeReading{}, Channels::ColorAndOpacity);
    if (diffuse)
        passes.diffuse = DiscPicture(checked(path, fit, std::move(*diffuse)));
    if (specular)
        passes.specular = DiscPicture(checked(path, fit, std::move(*specular)));
    return passes;
}

} // namespace

std::span<const std::string_view> words(ImagePass) { return passWords; }

std::string assetPath(const Level& level, const std::string& source)
{
    return source.starts_with("builtin:") ? source : (level.folder / source).string();
}

std::string assetKey(const std::string& path)
{
    std::error_code error;
    const auto time = std::filesystem::last_write_time(path, error);
    return path + "|" + (error ? std::string() : std::to_string(time.time_since_epoch().count()));
}

SpanGenerator prepare(const ImageLayer& layer, const Level& level)
{
    if (layer.source.empty())
        throw InvalidArgument("source: must be an image file; it is empty");
    const std::string path = assetPath(level, layer.source);
    const auto passes = level.assets->get<Passes>("image|" + std::string(wordOf(layer.fit)) + "|" + assetKey(path), [&] {
        Passes read = readPasses(path, layer.fit);
        const size_t bytes = read.diffuse.bytes() + read.specular.bytes();
        return SphereMapAssets::Made<Passes>{std::move(read), bytes};
    });
    const double turn = layer.turnDeg * pi / 180.0;
    const DiscLookup lookup{static_cast<float>(1.0 - layer.inset), static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))};
    const glm::vec3 tint(layer.tint * std::exp2(layer.exposure));
    const auto gain = static_cast<float>(std::exp2(layer.exposure));
    const double texel = level.texel() * (1.0 - layer.inset);
    const bool flip = layer.flip;
    const bool diffuse = layer.pass != ImagePass::Specular && !passes->diffuse.empty();
    const bool specular = layer.pass != ImagePass::Diffuse && !passes->specular.empty();
    return [=](const DiscSpan& where, ColorSpan& out) {
        DiscSpan at = where;
        if (flip)
            for (int i = 0; i < at.count; ++i)
                at.x[i] = -at.x[i];
        std::fill_n(out.a, at.count, 1.0f);
        if (diffuse)
            lookup.read(passes->diffuse.levelFor(texel), at, out);
        else
            fill(out, at.count, 0.0f, 0.0f, 0.0f);
        for (int i = 0; i < at.count; ++i) {
            out.r[i] *= tint.r;
            out.g[i] *= tint.g;
            out.b[i] *= tint.b;
        }
        if (specular) {
            ColorSpan over;
            lookup.read(passes->specular.levelFor(texel), at, over);
            for (int i = 0; i < at.count; ++i) {
                out.r[i] += gain * over.r[i];
                out.g[i] += gain * over.g[i];
                out.b[i] += gain * over.b[i];
            }
        }
    };
}

} // namespace mirrorball
