#include "color_parts.h"

#include "screen_color.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

double rounded(double x) { return std::round(x * 1e5) / 1e5; }

} // namespace

ColorParts colorParts(const glm::dvec3& linear)
{
    const double most = std::max({linear.r, linear.g, linear.b});
    const double ev = most > 1.0 ? std::log2(most) : 0.0;
    return {screenColor(linear / std::exp2(ev)), ev};
}

glm::dvec3 linearColor(const ColorParts& parts)
{
    const auto decode = [&](double x) { return rounded(static_cast<double>(decodeSrgb(static_cast<float>(x))) * std::exp2(parts.ev)); };
    return {decode(parts.shown.redF()), decode(parts.shown.greenF()), decode(parts.shown.blueF())};
}

QString hexText(const ColorParts& parts) { return parts.shown.name(QColor::HexRgb); }

std::optional<QColor> colorOfHex(const QString& text)
{
    static const QRegularExpression form(QStringLiteral("^#?([0-9a-fA-F]{6}|[0-9a-fA-F]{3})$"));
    const QRegularExpressionMatch match = form.match(text.trimmed());
    return match.hasMatch() ? std::optional(QColor(u'#' + match.captured(1))) : std::nullopt;
}

glm::dvec3 blackBody(double kelvin)
{
    const double t = 1e3 / std::clamp(kelvin, 1667.0, 25000.0);
    const double x = kelvin <= 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                      : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    const double y = kelvin <= 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : kelvin <= 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                        : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const glm::dvec3 xyz(x / y, 1.0, (1.0 - x - y) / y);
    const glm::dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                         0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
    const glm::dvec3 light = glm::max(rgb, glm::dvec3(0.0));
    return light / std::max({light.r, light.g, light.b});
}

} // namespace mirrorball::studio
