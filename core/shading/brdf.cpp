#include "brdf.h"

#include "brdf_file.h"
#include "metal_spectrum.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

namespace mirrorball {

namespace {

/// The keys of one model, taken out one by one so that what is left is what nobody knows.
class Keys {
public:
    Keys(std::string model, std::string_view text) : m_model(std::move(model))
    {
        for (size_t at = 0; at < text.size();) {
            const size_t end = std::min(text.find(',', at), text.size());
            const std::string_view part = text.substr(at, end - at);
            at = end + 1;
            const size_t equals = part.find('=');
            if (equals == std::string_view::npos || equals == 0)
                throw InvalidArgument("brdf " + m_model + ": expected key=value; it is " + inQuotes(part));
            if (!m_values.emplace(part.substr(0, equals), part.substr(equals + 1)).second)
                throw InvalidArgument("brdf " + m_model + ": " + std::string(part.substr(0, equals)) + " is given twice");
        }
    }

    std::optional<std::string> word(const std::string& key)
    {
        const auto found = m_values.find(key);
        if (found == m_values.end())
            return std::nullopt;
        std::string value = found->second;
        m_values.erase(found);
        return value;
    }
    std::optional<double> number(const std::string& key, double low, double high)
    {
        const auto text = word(key);
        if (!text)
            return std::nullopt;
        double value = 0.0;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
        if (error != std::errc() || end != text->data() + text->size() || !(value >= low && value <= high))
            throw InvalidArgument("brdf " + m_model + ": " + key + ": must be a number from " + numberText(low) + " to " +
                                  numberText(high) + "; it is " + inQuotes(*text));
        return value;
    }
    double needed(const std::string& key, double low, double high)
    {
        if (const auto value = number(key, low, high))
            return *value;
        throw InvalidArgument("brdf " + m_model + ": " + key + " is missing; write " + m_model + ":" + key + "=NUMBER");
    }
    void expectNoMore(const std::string& known) const
    {
        if (!m_values.empty())
            throw InvalidArgument("brdf " + m_model + ": does not know " + inQuotes(m_values.begin()->first) + "; it takes " + known);
    }

private:
    std::string m_model;
    std::map<std::string, std::string> m_values{};
};

constexpr double smallest = 1e-3; ///< of alpha and m: a lobe narrower than any probe's texels

BrdfFresnel takeFresnel(Keys& keys)
{
    BrdfFresnel fresnel;
    int given = 0;
    if (const auto ior = keys.number("ior", 1e-6, 1e6)) {
        fresnel = {.kind = BrdfFresnelKind::Dielectric, .index = *ior};
        ++given;
    }
    if (const auto f0 = keys.number("f0", 0.0, 1.0)) {
        fresnel = {.kind = BrdfFresnelKind::Schlick, .f0 = *f0};
        ++given;
    }
    if (const auto metal = keys.word("metal")) {
        fresnel = {.kind = BrdfFresnelKind::Metal, .metal = *metal};
        ++given;
    }
    if (given > 1)
        throw InvalidArgument("brdf: ior, f0 and metal say the same thing; give one of them");
    fresnelRgb(fresnel, 1.0); // refuses what is none
    return fresnel;
}

double takeAlpha(Keys& keys)
{
    const auto roughness = keys.number("roughness", std::sqrt(smallest), 1.0);
    if (!roughness)
        return keys.needed("alpha", smallest, 1.0);
    if (keys.word("alpha"))
        throw InvalidArgument("brdf: alpha is given beside roughness; it is its square, so give one of them");
    return *roughness * *roughness;
}

Brdf lafortuneFrom(std::string_view text)
{
    LafortuneBrdf model{.lobes = {}};
    BrdfFresnel fresnel;
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find('/', at), text.size());
        Keys keys("lafortune", text.substr(at, end - at));
        at = end + 1;
        LafortuneLobe lobe;
        lobe.exponent = keys.needed("exponent", 0.0, 1e6);
        lobe.cxy = keys.number("cxy", -10.0, 10.0).value_or(-1.0);
        lobe.cz = keys.number("cz", -10.0, 10.0).value_or(1.0);
        lobe.weight = keys.number("weight", 0.0, 1e6).value_or(1.0);
        if (model.lobes.empty())
            fresnel = takeFresnel(keys);
        keys.expectNoMore("exponent, cxy, cz, weight; ior, f0 or metal with the first lobe");
        model.lobes.push_back(lobe);
        if (model.lobes.size() > 64)
            throw InvalidArgument("brdf lafortune: has more than 64 lobes");
    }
    return {model, fresnel};
}

std::string fresnelText(const BrdfFresnel& fresnel)
{
    switch (fresnel.kind) {
    case BrdfFresnelKind::Dielectric:
        return ",ior=" + numberText(fresnel.index);
    case BrdfFresnelKind::Schlick:
        return ",f0=" + numberText(fresnel.f0);
    case BrdfFresnelKind::Metal:
        return ",metal=" + fresnel.metal;
    case BrdfFresnelKind::None:
        break;
    }
    return "";
}

struct Describe {
    std::string operator()(const PhongBrdf& b) const
    {
        return "phong:exponent=" + numberText(b.exponent) + (b.strength == 1.0 ? "" : ",strength=" + numberText(b.strength));
    }
    std::string operator()(const LafortuneBrdf& b) const
    {
        std::string text = "lafortune:";
        for (size_t i = 0; i < b.lobes.size(); ++i)
            text += (i ? "/" : "") + ("exponent=" + numberText(b.lobes[i].exponent)) + ",cxy=" + numberText(b.lobes[i].cxy) +
                    ",cz=" + numberText(b.lobes[i].cz) + ",weight=" + numberText(b.lobes[i].weight);
        return text;
    }
    std::string operator()(const WardBrdf& b) const { return "ward:alpha=" + numberText(b.alpha); }
    std::string operator()(const CookTorranceBrdf& b) const { return "cook-torrance:m=" + numberText(b.m); }
    std::string operator()(const BeckmannBrdf& b) const { return "beckmann:alpha=" + numberText(b.alpha); }
    std::string operator()(const GgxBrdf& b) const { return "ggx:alpha=" + numberText(b.alpha); }
    std::string operator()(const MeasuredBrdf& b) const { return b.name(); }
};

double phongAlpha(double exponent) { return std::clamp(std::sqrt(2.0 / (4.0 * exponent + 2.0)), smallest, 1.0); }

struct EquivalentAlpha {
    double operator()(const PhongBrdf& b) const { return phongAlpha(b.exponent); }
    double operator()(const LafortuneBrdf& b) const
    {
        const auto heaviest = std::max_element(b.lobes.begin(), b.lobes.end(),
                                               [](const LafortuneLobe& x, const LafortuneLobe& y) { return x.weight < y.weight; });
        return phongAlpha(heaviest->exponent);
    }
    double operator()(const WardBrdf& b) const { return std::min(b.alpha, 1.0); }
    double operator()(const CookTorranceBrdf& b) const { return std::min(b.m, 1.0); }
    double operator()(const BeckmannBrdf& b) const { return b.alpha; }
    double operator()(const GgxBrdf& b) const { return b.alpha; }
    double operator()(const MeasuredBrdf& b) const
    {
        const auto green = [&](double thetaH) {
            const double theta = 2.0 * thetaH;
            return b.value(std::cos(theta), 1.0, std::cos(theta)).g;
        };
        const double peak = green(0.0);
        double thetaH = 0.0;
        while (thetaH < 0.24 * pi && green(thetaH) > 0.5 * peak)
            thetaH += 1e-3;
        return std::clamp(std::tan(thetaH) / std::sqrt(std::sqrt(2.0) - 1.0), smallest, 1.0);
    }
};

} // namespace

glm::dvec3 evaluate(const Brdf& brdf, const glm::dvec3& l, const glm::dvec3& v)
{
    if (!(l.z > 0.0 && v.z > 0.0))
        return glm::dvec3(0.0);
    const double lv = std::clamp(glm::dot(l, v), -1.0, 1.0);
    const glm::dvec3 f = std::visit([&](const auto& model) { return glm::dvec3(model.value(l.z, v.z, lv)); }, brdf.model);
    return f * fresnelRgb(brdf.fresnel, halfAngles(l.z, v.z, lv).hl);
}

Brdf brdfFromText(const std::string& text)
{
    const size_t colon = text.find(':');
    const std::string model = text.substr(0, colon);
    const std::string_view rest = colon == std::string::npos ? std::string_view() : std::string_view(text).substr(colon + 1);
    constexpr auto fresnelKeys = "ior, f0 or metal";
    const auto finish = [&](Keys& keys, BrdfModel made, const std::string& own) {
        Brdf brdf{std::move(made), takeFresnel(keys)};
        keys.expectNoMore(own + "; " + fresnelKeys);
        return brdf;
    };
    if (model == "lafortune")
        return lafortuneFrom(rest);
    if (model == "phong") {
        Keys keys(model, rest);
        const double exponent = keys.needed("exponent", 0.0, 1e6);
        const double strength = keys.number("strength", 0.0, 1e6).value_or(1.0);
        return finish(keys, PhongBrdf{exponent, strength}, "exponent, strength");
    }
    if (model == "ward") {
        Keys keys(model, rest);
        const double alpha = keys.needed("alpha", smallest, 10.0);
        return finish(keys, WardBrdf{alpha}, "alpha");
    }
    if (model == "cook-torrance") {
        Keys keys(model, rest);
        const double m = keys.needed("m", smallest, 10.0);
        return finish(keys, CookTorranceBrdf{m}, "m");
    }
    if (model == "beckmann" || model == "ggx") {
        Keys keys(model, rest);
        const double alpha = takeAlpha(keys);
        return model == "ggx" ? finish(keys, GgxBrdf{alpha}, "alpha or roughness")
                              : finish(keys, BeckmannBrdf{alpha}, "alpha or roughness");
    }
    if (isBrdfFile(text))
        return {readBrdf(text), {}};
    throw InvalidArgument("brdf: " + inQuotes(text) +
                          " is neither a model nor a measured file; choose phong, lafortune, ward, cook-torrance, beckmann, ggx, or a file "
                          "that ends in .binary, .brdf, .csv or .txt");
}

std::string describe(const Brdf& brdf) { return std::visit(Describe{}, brdf.model) + fresnelText(brdf.fresnel); }

double equivalentAlpha(const Brdf& brdf) { return std::visit(EquivalentAlpha{}, brdf.model); }

} // namespace mirrorball
