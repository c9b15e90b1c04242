#include "curve_picture.h"

#include "picture_canvas.h"

#include "core/base/error.h"
#include "core/image/text_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mirrorball {

namespace {

constexpr int leftMargin = 58, rightPad = 14, top = 26, bottom = 38;
constexpr glm::vec3 ink(0.2f), faint(0.93f), firm(0.8f);

std::string number(double value)
{
    char text[24];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

int widthOf(const std::string& words) { return letterWidth * static_cast<int>(words.size()); }

/// Ranges of both axes and where a value lies in the picture.
struct Axes {
    double x0 = std::numeric_limits<double>::infinity(), x1 = -x0, y0 = x0, y1 = -x0; ///< y in decades
    glm::vec2 corner{}, size{};                                                       ///< lower left; pixels

    glm::vec2 place(const glm::dvec2& p) const
    {
        return corner + size * glm::vec2((p.x - x0) / (x1 - x0), -(std::log10(p.y) - y0) / (y1 - y0));
    }
};

Axes axesOf(const CurvePlot& plot, int rightMargin)
{
    Axes axes;
    for (const Curve& curve : plot.curves)
        for (const glm::dvec2& p : curve.points)
            if (p.y > 0.0) {
                axes.x0 = std::min(axes.x0, p.x);
                axes.x1 = std::max(axes.x1, p.x);
                axes.y0 = std::min(axes.y0, std::log10(p.y));
                axes.y1 = std::max(axes.y1, std::log10(p.y));
            }
    if (!(axes.y0 <= axes.y1))
        throw InvalidArgument("plot: there is no point to draw");
    for (const double x : plot.xTicks) {
        axes.x0 = std::min(axes.x0, x);
        axes.x1 = std::max(axes.x1, x);
    }
    if (axes.x0 == axes.x1)
        axes.x1 += 1.0;
    axes.y0 = std::floor(axes.y0);
    axes.y1 = std::max(std::ceil(axes.y1), axes.y0 + 1.0);
    axes.corner = {leftMargin, plot.height - bottom};
    axes.size = {plot.width - leftMargin - rightMargin, plot.height - top - bottom};
    return axes;
}

void drawGrid(PictureCanvas& canvas, const CurvePlot& plot, const Axes& axes)
{
    const int left = static_cast<int>(axes.corner.x), right = left + static_cast<int>(axes.size.x);
    for (int decade = static_cast<int>(axes.y0); decade <= static_cast<int>(axes.y1); ++decade)
        for (const int step : {1, 2, 5}) {
            const double value = step * std::pow(10.0, decade);
            if (std::log10(value) > axes.y1 + 1e-9)
                break;
            const int y = static_cast<int>(axes.place({axes.x0, value}).y);
            for (int x = left; x <= right; ++x)
                canvas.blend(x, y, step == 1 ? firm : faint, 1.0f);
            const std::string label = number(value);
            canvas.text(label, {left - widthOf(label) - 6, y - textHeight / 2}, step == 1 ? ink : glm::vec3(0.55f));
        }
    for (const double tick : plot.xTicks) {
        const int x = static_cast<int>(axes.place({tick, std::pow(10.0, axes.y0)}).x);
        for (int y = top; y <= plot.height - bottom; ++y)
            canvas.blend(x, y, faint, 1.0f);
        const std::string label = number(tick);
        canvas.text(label, {x - widthOf(label) / 2, plot.height - bottom + 6}, ink);
    }
    canvas.text(plot.title, {leftMargin, 8}, ink);
    canvas.text(plot.yTitle, {6, 8}, ink);
    canvas.text(plot.xTitle, {(left + right - widthOf(plot.xTitle)) / 2, plot.height - 16}, ink);
}

/// Heights of the labels: those of the last points, moved apart.
std::vector<int> labelHeights(const CurvePlot& plot, const Axes& axes)
{
    std::vector<size_t> order;
    std::vector<int> y(plot.curves.size(), 0);
    for (size_t i = 0; i < plot.curves.size(); ++i)
        for (const glm::dvec2& p : plot.curves[i].points)
            if (p.y > 0.0) {
                y[i] = static_cast<int>(axes.place(p).y) - textHeight / 2;
                if (order.empty() || order.back() != i)
                    order.push_back(i);
            }
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return y[a] < y[b]; });
    constexpr int apart = textHeight + 3;
    for (size_t k = 1; k < order.size(); ++k)
        y[order[k]] = std::max(y[order[k]], y[order[k - 1]] + apart);
    int limit = plot.height - bottom - textHeight;
    for (size_t k = order.size(); k-- > 0; limit -= apart) {
        y[order[k]] = std::min(y[order[k]], limit);
        limit = y[order[k]];
    }
    return y;
}

} // namespace

glm::vec3 curveColor(size_t i)
{
    static constexpr std::array<std::array<int, 3>, 8> colors{
        {{0, 114, 178}, {86, 180, 233}, {213, 94, 0}, {230, 159, 0}, {204, 121, 167}, {0, 158, 115}, {90, 90, 90}, {200, 180, 40}}};
    const auto& c = colors[i % colors.size()];
    return glm::vec3(c[0], c[1], c[2]) / 255.0f;
}

Image curvePicture(const CurvePlot& plot)
{
    if (plot.width < 320 || plot.height < 200)
        throw InvalidArgument("plot: must be at least 320 x 200 pixels");
    int widest = 0;
    for (const Curve& curve : plot.curves)
        widest = std::max(widest, widthOf(curve.label));
    const Axes axes = axesOf(plot, widest + rightPad + 8);
    PictureCanvas canvas(plot.width, plot.height);
    drawGrid(canvas, plot, axes);
    const std::vector<int> heights = labelHeights(plot, axes);
    for (size_t i = 0; i < plot.curves.size(); ++i) {
        std::vector<glm::vec2> points;
        for (const glm::dvec2& p : plot.curves[i].points)
            if (p.y > 0.0)
                points.push_back(axes.place(p));
        canvas.line(points, plot.curves[i].color, {.isDotted = true});
        if (!points.empty())
            canvas.text(plot.curves[i].label, {plot.width - rightPad - widest, heights[i]}, plot.curves[i].color);
    }
    return canvas.take();
}

} // namespace mirrorball
