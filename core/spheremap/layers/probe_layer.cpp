#include "probe_layer.h"

#include "core/spheremap/document/assets.h"
#include "core/spheremap/evaluation/disc_picture.h"
#include "image_layer.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/filter/prefilter.h"
#include "core/image/probe_file.h"
#include "core/shading/conductor.h"
#include "core/sphere/sphere_map.h"

#include <algorithm>
#include <array>
#include <memory>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array lobeWords{"mirror"sv, "phong"sv, "ggx"sv, "diffuse"sv};
constexpr std::array shareWords{"mirrored"sv, "transmitted"sv};

Lobe lobeOf(const ProbeLayer& layer)
{
    switch (layer.lobe) {
    case ProbeLobe::Phong:
        return phongLobe(layer.exponent);
    case ProbeLobe::Ggx:
        return ggxLobe(layer.roughness * layer.roughness);
    case ProbeLobe::Diffuse:
        return diffuseLobe();
    case ProbeLobe::Mirror:
        break;
    }
    return ggxLobe(0.0);
}

/// Texels that show all of a lobe's detail: about eight over its full width, which the disc shows at half the angle.
int discSize(const Lobe& lobe)
{
    const double width = lobe.isMirror() ? 0.0 : LobeShape(lobe).halfWidth();
    const double texels = width > 0.0 ? 2.0 * 8.0 / width : 1e9;
    return texels <= 128.0 ? 128 : texels <= 256.0 ? 256 : texels <= 512.0 ? 512 : 1024;
}

/// The disc of a filtered probe that is tipped by an angle: what is above moves towards the eye.
/// @param toDirection  of a place in the disc
template <typename ToDirection>
Image discOf(const EnvironmentMap& filtered, double tilt, int size, const ToDirection& toDirection)
{
    const double c = std::cos(tilt), s = std::sin(tilt);
    Image disc(size, size, 3);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            glm::dvec2 q = disc::inscribed(size).fromImage({x + 0.5, y + 0.5});
            const double length = glm::length(q);
            if (length > 1.0)
                q /= length;
            const glm::dvec3 d = toDirection(q);
            const glm::vec3 rgb = filtered.radiance({d.x, c * d.y + s * d.z, c * d.z - s * d.y});
            std::copy_n(&rgb.x, 3, disc.texel(x, y));
        }
    return disc;
}

DiscPicture bake(const ProbeLayer& layer, const std::string& path, SphereMapAssets& assets)
{
    const auto probe = assets.get<std::shared_ptr<FilterSource>>("filter source|" + assetKey(path), [&] {
        EnvironmentMap map = readProbe(path).map;
        const size_t bytes = 2 * map.image.texels.size() * sizeof(float); // and its spectrum, of about as many values
        return SphereMapAssets::Made<std::shared_ptr<FilterSource>>{std::make_shared<FilterSource>(std::move(map)), bytes};
    });
    const Lobe lobe = lobeOf(layer);
    // The diffuse part is looked up by the normal, not by the mirror direction; what is tipped, through a map of all directions.
    const bool diffuse = layer.lobe == ProbeLobe::Diffuse, direct = !diffuse && layer.tiltDeg == 0.0;
    const int size = diffuse ? 128 : discSize(lobe);
    const PrefilterOptions options{.lobe = lobe,
                                   .target = diffuse  ? MapLayout{Parameterization::Octahedral, 64, 0}
                                             : direct ? MapLayout{Parameterization::Sphere, size, 0}
                                                      : MapLayout{Parameterization::Octahedral, 2 * size, 0},
                                   .tolerance = 1e-4,
                                   .yaw = layer.yawDeg * pi / 180.0};
    EnvironmentMap map = prefilter(**probe, options).map;
    if (direct)
        return DiscPicture(std::move(map.image));
    const double tilt = layer.tiltDeg * pi / 180.0;
    return DiscPicture(
        diffuse ? discOf(map, tilt, size, [](const glm::dvec2& q) { return glm::dvec3(q, std::sqrt(std::max(1.0 - glm::dot(q, q), 0.0))); })
                : discOf(map, tilt, size, sphere_map::directionFromDisc));
}

/// F (or 1 - F) times a color, by n.v = z: a table over [0, 1].
class ShareTable {
public:
    ShareTable(const Fresnel& fresnel, FresnelShare share, const glm::dvec3& color)
    {
        for (int i = 0; i <= entries + 1; ++i) {
            const glm::dvec3 f = reflectance(fresnel, std::min(static_cast<double>(i) / entries, 1.0));
            m_entries[static_cast<size_t>(i)] = glm::vec3(color * (share == FresnelShare::Mirrored ? f : 1.0 - f));
        }
    }
    glm::vec3 at(float z) const
    {
        const float x = z * static_cast<float>(entries);
        const int i = static_cast<int>(x);
        return glm::mix(m_entries[static_cast<size_t>(i)], m_entries[static_cast<size_t>(i) + 1], x - static_cast<float>(i));
    }

private:
    static constexpr int entries = 512;
    std::array<glm::vec3, entries + 2> m_entries{};
};

} // namespace

std::span<const std::string_view> words(ProbeLobe) { return lobeWords; }
std::span<const std::string_view> words(FresnelShare) { return shareWords; }

SpanGenerator prepare(const ProbeLayer& layer, const Level& level)
{
    if (layer.source.empty())
        throw InvalidArgument("source: must be an image file or builtin:NAME; it is empty");
    Fresnel fresnel{.kind = layer.fresnel, .index = layer.index};
    if (layer.fresnel == FresnelKind::Conductor) {
        const auto metal = conductorFromName(layer.metal);
        if (!metal)
            throw InvalidArgument("metal: " + inQuotes(layer.metal) + " is no metal that is built in");
        fresnel.conductor = *metal;
    }
    const std::string path = assetPath(level, layer.source);
    const std::string key =
        "probe|" + assetKey(path) + "|" + describe(lobeOf(layer)) + "|" + numberText(layer.yawDeg) + "|" + numberText(layer.tiltDeg);
    SphereMapAssets* assets = level.assets;
    const auto picture = assets->get<DiscPicture>(key, [&] {
        DiscPicture baked = bake(layer, path, *assets);
        const size_t bytes = baked.bytes();
        return SphereMapAssets::Made<DiscPicture>{std::move(baked), bytes};
    });
    const auto share = std::make_shared<const ShareTable>(fresnel, layer.share, layer.tint * std::exp2(layer.exposure));
    return [picture, share, texel = level.texel()](const DiscSpan& at, ColorSpan& out) {
        DiscLookup{}.read(picture->levelFor(texel), at, out);
        for (int i = 0; i < at.count; ++i) {
            const glm::vec3 f = share->at(at.z[i]);
            out.r[i] *= f.r;
            out.g[i] *= f.g;
            out.b[i] *= f.b;
        }
        std::fill_n(out.a, at.count, 1.0f);
    };
}

} // namespace mirrorball
