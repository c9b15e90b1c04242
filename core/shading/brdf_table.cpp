#include "brdf_table.h"

#include "reflection_kernel.h"

#include "core/base/error.h"

#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 3> tableNames{"albedo", "ab", "fresnel"};

/// The model at another roughness, for the families that have one.
BrdfModel atRoughness(const BrdfModel& model, double roughness)
{
    const double alpha = std::max(roughness * roughness, 1e-3);
    if (std::holds_alternative<GgxBrdf>(model))
        return GgxBrdf{alpha};
    if (std::holds_alternative<BeckmannBrdf>(model))
        return BeckmannBrdf{alpha};
    if (std::holds_alternative<CookTorranceBrdf>(model))
        return CookTorranceBrdf{alpha};
    if (std::holds_alternative<WardBrdf>(model))
        return WardBrdf{alpha};
    throw InvalidArgument("--table: ab has a row for every roughness; choose ggx, beckmann, cook-torrance or ward");
}

void put(float* texel, const glm::dvec3& value)
{
    for (int c = 0; c < 3; ++c)
        texel[c] = static_cast<float>(value[c]);
}

} // namespace

std::optional<BrdfTable> brdfTableFromName(std::string_view name)
{
    for (size_t i = 0; i < tableNames.size(); ++i)
        if (tableNames[i] == name)
            return static_cast<BrdfTable>(i);
    return std::nullopt;
}

std::string brdfTableNames() { return "albedo, ab, fresnel"; }

std::string brdfTableHelp()
{
    return "albedo (directional albedo over n.v), ab (the split sum's scale and bias over n.v and roughness) or fresnel (F over the "
           "cosine)";
}

ScaleBias scaleAndBias(const BrdfModel& model, double view)
{
    const ReflectionKernel kernel({model, {}}, view);
    const LobeNodes nodes = lobeNodes(view);
    const auto values = kernelAtNodes(kernel, nodes);
    ScaleBias result;
    for (size_t r = 0; r < nodes.rings.size(); ++r)
        for (size_t i = nodes.rings[r].first; i < nodes.end(r); ++i) {
            const double hl = std::sqrt(std::max(0.5 * (1.0 + nodes.lv[i]), 0.0)), m = 1.0 - std::min(hl, 1.0);
            const double part = nodes.rings[r].weight * nodes.chiWeight[i] * values[0][i], grazing = m * m * m * m * m;
            result.a += part * (1.0 - grazing);
            result.b += part * grazing;
        }
    return result;
}

Image makeBrdfTable(const Brdf& brdf, BrdfTable table, int size, const JobControl& job)
{
    const bool isMeasured = std::holds_alternative<MeasuredBrdf>(brdf.model);
    if (isMeasured && table != BrdfTable::Albedo)
        throw InvalidArgument("--table: a measurement has its Fresnel term in its values; choose albedo");
    const int n = size > 0 ? size : (table == BrdfTable::Fresnel ? 256 : 128);
    const auto viewAt = [n](int i) { return std::acos((i + 0.5) / n); };
    if (table == BrdfTable::Fresnel) {
        Image image(n, 1);
        const FresnelCurve curve(brdf.fresnel);
        for (int i = 0; i < n; ++i)
            put(image.texel(i, 0), curve.at(n > 1 ? static_cast<double>(i) / (n - 1) : 1.0));
        return image;
    }
    if (table == BrdfTable::Albedo) {
        Image image(n, 1);
        parallelRows(n, job, [&](int first, int last) {
            for (int i = first; i < last; ++i)
                put(image.texel(i, 0), directionalAlbedo(brdf, viewAt(i)));
        });
        return image;
    }
    atRoughness(brdf.model, 0.5); // refuses before any work
    Image image(n, n);
    parallelRows(
        n, job,
        [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < n; ++x) {
                    const ScaleBias ab = scaleAndBias(atRoughness(brdf.model, (y + 0.5) / n), viewAt(x));
                    put(image.texel(x, y), {ab.a, ab.b, 0.0});
                }
        },
        1);
    return image;
}

} // namespace mirrorball
