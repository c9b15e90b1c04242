#include "sphere_map_editor.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

// What strokes are drawn with.
namespace mirrorball::studio {

namespace {
const QString stabilizerKey = QStringLiteral("painting/stabilizer");
} // namespace

PenTouch penTouch(const QTabletEvent& event)
{
    return {.pressure = event.pressure(),
            .end = event.pointerType() == QPointingDevice::PointerType::Eraser ? PenEnd::Eraser : PenEnd::Tip,
            .tilt = {event.xTilt(), -event.yTilt()}}; // Qt's goes down
}

Brush draggedBrush(const Brush& before, const QPointF& moved)
{
    Brush brush = before;
    brush.radius = std::clamp(std::round(brush.radius * std::exp(moved.x() / 120.0) * 1e4) / 1e4, smallestRadius, largestRadius);
    brush.hardness = std::clamp(std::round((brush.hardness - moved.y() / 250.0) * 100.0) / 100.0, 0.0, 1.0);
    return brush;
}

void SphereMapEditor::setBrush(const Brush& brush)
{
    if (brush == m_brush)
        return;
    m_brush = brush;
    emit brushChanged();
}

void SphereMapEditor::stepBrush(int steps)
{
    Brush brush = m_brush;
    brush.radius = std::clamp(std::round(brush.radius * std::pow(1.15, steps) * 1e4) / 1e4, smallestRadius, largestRadius);
    setBrush(brush);
}

void SphereMapEditor::setSymmetry(const Symmetry& symmetry)
{
    if (symmetry == m_symmetry)
        return;
    m_symmetry = symmetry;
    emit brushChanged();
}

void SphereMapEditor::setTool(PaintTool tool)
{
    if (tool == m_tool)
        return;
    m_tool = tool;
    emit toolChanged();
}

void SphereMapEditor::setPaintsOnModel(bool on)
{
    if (on == m_paintsOnModel)
        return;
    m_paintsOnModel = on;
    emit toolChanged();
}

double keptStabilizer()
{
    const double pixels = QSettings().value(stabilizerKey).toDouble();
    return pixels >= 0.0 ? std::min(pixels, longestStabilizer) : 0.0; // the file is anybody's
}

void SphereMapEditor::setStabilizer(double pixels)
{
    pixels = std::clamp(pixels, 0.0, longestStabilizer);
    if (pixels == m_stabilizer)
        return;
    m_stabilizer = pixels;
    QSettings().setValue(stabilizerKey, pixels);
    emit brushChanged();
}

void SphereMapEditor::pickColor(const glm::dvec2& q)
{
    const Image& picture = m_levelImage.empty() ? m_picture : m_levelImage;
    if (picture.empty())
        return;
    const int n = picture.width;
    const auto texel = [n](double v) { return std::clamp(static_cast<int>((v + 1.0) * 0.5 * n), 0, n - 1); };
    const float* rgba = picture.texel(texel(q.x), texel(-q.y));
    if (!(rgba[3] > 0.0f))
        return;
    Brush brush = m_brush;
    for (int c = 0; c < 3; ++c)
        brush.color[c] = std::clamp(std::round(static_cast<double>(rgba[c] / rgba[3]) * 1e5) / 1e5, 0.0, 1000.0);
    setBrush(brush);
}

} // namespace mirrorball::studio
