#include "brdf_fresnel.h"

#include "fresnel.h"
#include "metal_spectrum.h"
#include "observer.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace mirrorball {

namespace {

constexpr int intervals = 4096;

/// n and k at a wavelength, linear between the rows.
IndexRow indexAt(std::span<const IndexRow> rows, double wavelength)
{
    size_t i = 1;
    while (i + 1 < rows.size() && rows[i].wavelength < wavelength)
        ++i;
    const IndexRow &a = rows[i - 1], &b = rows[i];
    const double t = std::clamp((wavelength - a.wavelength) / (b.wavelength - a.wavelength), 0.0, 1.0);
    return {wavelength, a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

/// One wavelength of a metal's spectrum.
struct Band {
    IndexRow index;
    glm::dvec3 weight;
};
std::vector<Band> bandsOf(const std::string& metal)
{
    const auto rows = metalSpectrum(metal);
    if (rows.empty())
        throw InvalidArgument("metal: '" + metal + "' is none that is known; choose one of " + metalNames());
    std::vector<double> wavelengths;
    for (int i = 0; i <= 80; ++i)
        wavelengths.push_back(380.0 + 5.0 * i);
    const std::vector<glm::dvec3> weights = observerWeights(wavelengths);
    std::vector<Band> bands;
    for (size_t i = 0; i < wavelengths.size(); ++i)
        bands.push_back({indexAt(rows, wavelengths[i]), weights[i]});
    return bands;
}

glm::dvec3 reflectance(const std::vector<Band>& bands, double c)
{
    glm::dvec3 sum(0.0);
    for (const Band& band : bands)
        sum += band.weight * fresnelConductor(c, band.index.n, band.index.k);
    return sum;
}

/// Over the cosine; every kernel of the metal reads the same one.
std::shared_ptr<const std::vector<glm::dvec3>> tableOf(const std::string& metal)
{
    static std::mutex mutex;
    static std::map<std::string, std::shared_ptr<const std::vector<glm::dvec3>>> made;
    const std::vector<Band> bands = bandsOf(metal);
    const std::lock_guard lock(mutex);
    auto& table = made[metal];
    if (!table) {
        std::vector<glm::dvec3> values;
        for (int i = 0; i <= intervals; ++i)
            values.push_back(reflectance(bands, static_cast<double>(i) / intervals));
        table = std::make_shared<const std::vector<glm::dvec3>>(std::move(values));
    }
    return table;
}

void check(const BrdfFresnel& fresnel)
{
    if (fresnel.kind == BrdfFresnelKind::Dielectric && !(std::isfinite(fresnel.index) && fresnel.index > 0.0))
        throw InvalidArgument("ior: the index of refraction must be finite and greater than 0");
    if (fresnel.kind == BrdfFresnelKind::Schlick && !(fresnel.f0 >= 0.0 && fresnel.f0 <= 1.0))
        throw InvalidArgument("f0: the reflectance at normal incidence must lie in [0, 1]");
}

} // namespace

glm::dvec3 fresnelRgb(const BrdfFresnel& fresnel, double c)
{
    check(fresnel);
    switch (fresnel.kind) {
    case BrdfFresnelKind::Dielectric:
        return glm::dvec3(fresnelDielectric(c, fresnel.index));
    case BrdfFresnelKind::Schlick:
        return glm::dvec3(fresnelSchlick(c, fresnel.f0));
    case BrdfFresnelKind::Metal:
        return reflectance(bandsOf(fresnel.metal), c);
    case BrdfFresnelKind::None:
        break;
    }
    return glm::dvec3(1.0);
}

FresnelCurve::FresnelCurve(const BrdfFresnel& fresnel) : m_fresnel(fresnel)
{
    check(fresnel);
    if (fresnel.kind != BrdfFresnelKind::Metal)
        return;
    m_table = tableOf(fresnel.metal);
}

glm::dvec3 FresnelCurve::at(double c) const
{
    switch (m_fresnel.kind) {
    case BrdfFresnelKind::Dielectric:
        return glm::dvec3(fresnelDielectric(c, m_fresnel.index));
    case BrdfFresnelKind::Schlick:
        return glm::dvec3(fresnelSchlick(c, m_fresnel.f0));
    case BrdfFresnelKind::Metal: {
        const double x = std::clamp(c, 0.0, 1.0) * intervals;
        const auto i = std::min(static_cast<size_t>(x), static_cast<size_t>(intervals - 1));
        return glm::mix((*m_table)[i], (*m_table)[i + 1], x - static_cast<double>(i));
    }
    case BrdfFresnelKind::None:
        break;
    }
    return glm::dvec3(1.0);
}

} // namespace mirrorball
