#include "measured_domain.h"

#include "picture_canvas.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/image/color_scale.h"
#include "core/image/text_picture.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mirrorball {

namespace {

constexpr glm::vec3 ink(0.2f), faint(0.85f), light(0.9f, 0.45f, 0.0f), mirror(0.35f);
constexpr double decades = 4.0; ///< of brightness
constexpr double sameLight = 0.5 * pi / 180.0;

double angleOf(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

/// Orthographic, with the surface's normal upwards and the light coming from the left.
class View {
public:
    explicit View(int size) : m_scale(0.42 * size), m_origin(0.5 * size, 0.8 * size) {}
    glm::vec2 place(const glm::dvec3& p) const
    {
        return glm::vec2(m_origin + m_scale * glm::dvec2(glm::dot(p, m_right), -glm::dot(p, m_up)));
    }

private:
    double m_scale;
    glm::dvec2 m_origin;
    glm::dvec3 m_toViewer = glm::normalize(glm::dvec3(0.25, -0.85, 0.4));
    glm::dvec3 m_right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), m_toViewer));
    glm::dvec3 m_up = glm::cross(m_toViewer, m_right);
};

/// At polar angle t from the normal, f about it from the light's side.
glm::dvec3 onSphere(double t, double f) { return {-std::sin(t) * std::cos(f), -std::sin(t) * std::sin(f), std::cos(t)}; }

void drawQuarter(PictureCanvas& canvas, const View& view)
{
    constexpr int steps = 48;
    const auto arc = [&](const auto& at, float width) {
        std::vector<glm::vec2> points;
        for (int i = 0; i <= steps; ++i)
            points.push_back(view.place(at(static_cast<double>(i) / steps)));
        canvas.line(points, faint, {.width = width});
    };
    for (const double polar : {30.0, 60.0, 90.0})
        arc([&](double share) { return onSphere(polar * pi / 180.0, share * pi); }, polar == 90.0 ? 2.0f : 1.0f);
    for (int azimuth = 0; azimuth <= 180; azimuth += 30)
        arc([&](double share) { return onSphere(share * 0.5 * pi, azimuth * pi / 180.0); }, azimuth % 180 == 0 ? 2.0f : 1.0f);
    canvas.line({view.place({-1.0, 0.0, 0.0}), view.place({1.0, 0.0, 0.0})}, faint, {.width = 2.0f});
    canvas.line({view.place({0.0, 0.0, 0.0}), view.place({0.0, 0.0, 1.15})}, ink, {.width = 1.2f});
}

void drawRay(PictureCanvas& canvas, const View& view, double incidence)
{
    const glm::vec2 from = view.place(1.15 * onSphere(incidence, 0.0)), to = view.place(glm::dvec3(0.0));
    canvas.line({from, to}, light, {.width = 2.5f});
    const glm::vec2 along = glm::normalize(to - from), across(-along.y, along.x);
    for (const float side : {-1.0f, 1.0f})
        canvas.line({to - 14.0f * along + side * 6.0f * across, to}, light, {.width = 2.5f});
    canvas.line({to, view.place(1.1 * onSphere(incidence, pi))}, mirror, {.width = 1.2f});
}

} // namespace

Image measuredDomainPicture(const MeasuredBrdf& brdf, double incidence, int size)
{
    if (size < 200 || size > 4096)
        throw InvalidArgument("size: must be a whole number from 200 to 4096");
    if (brdf.samples().empty())
        throw InvalidArgument(inQuotes(brdf.name()) + " is measured in all directions of a grid; give a file of single measurements");
    const auto distance = [&](const MeasuredBrdf::Sample& s) { return std::abs(angleOf(s.nl) - incidence); };
    const auto nearest = std::min_element(brdf.samples().begin(), brdf.samples().end(),
                                          [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    const double measured = angleOf(nearest->nl);
    std::vector<MeasuredBrdf::Sample> shown;
    double most = 1e-300;
    const auto mean = [](const MeasuredBrdf::Sample& s) { return std::max((s.value.r + s.value.g + s.value.b) / 3.0, 0.0); };
    for (const MeasuredBrdf::Sample& s : brdf.samples())
        if (std::abs(angleOf(s.nl) - measured) < sameLight) {
            shown.push_back(s);
            most = std::max(most, mean(s));
        }
    std::sort(shown.begin(), shown.end(), [&](const auto& a, const auto& b) { return mean(a) < mean(b); }); // bright ones on top

    PictureCanvas canvas(size, size);
    const View view(size);
    drawQuarter(canvas, view);
    drawRay(canvas, view, measured);
    const double sinL = std::sin(measured);
    for (const MeasuredBrdf::Sample& s : shown) {
        const double sinV = std::sin(angleOf(s.nv)), product = sinL * sinV;
        const double azimuth = product > 1e-9 ? angleOf((s.lv - s.nl * s.nv) / product) : pi;
        const double share = 1.0 + std::log10(std::max(mean(s) / most, 1e-30)) / decades;
        canvas.dot(view.place(onSphere(angleOf(s.nv), azimuth)), 0.008f * static_cast<float>(size), falseColor(std::max(share, 0.0)));
    }
    const int line = textHeight + 4;
    const std::string degrees = std::to_string(std::lround(measured * 180.0 / pi));
    canvas.text(brdf.name(), {10, 10}, ink);
    canvas.text("light from " + degrees + " degrees, " + std::to_string(shown.size()) + " views", {10, 10 + line}, light);
    canvas.text("gray: the mirror direction; colors: " + std::to_string(static_cast<int>(decades)) + " decades below the strongest",
                {10, 10 + 2 * line}, mirror);
    return canvas.take();
}

} // namespace mirrorball
