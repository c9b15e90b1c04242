#include "color_scale_bar.h"

#include "core/image/color_scale.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr int barHeight = 10;

QColor toQColor(const glm::vec3& c) { return QColor::fromRgbF(c.r, c.g, c.b); }

} // namespace

QString shortNumberText(double value)
{
    const double magnitude = std::abs(value);
    if (magnitude != 0.0 && (magnitude < 1e-3 || magnitude >= 1e5))
        return QString::number(value, 'e', 1)
            .replace(QStringLiteral("e-0"), QStringLiteral("e-"))
            .replace(QStringLiteral("e+0"), QStringLiteral("e"));
    return QString::number(value, 'g', 3);
}

ColorScaleBar::ColorScaleBar(QWidget* parent) : QWidget(parent) { setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed); }

void ColorScaleBar::show(Colors colors, std::vector<Tick> ticks, const QString& unit, const QString& help)
{
    m_colors = colors;
    m_ticks = std::move(ticks);
    m_unit = unit;
    setToolTip(help);
    setAccessibleName(help);
    QString spoken;
    for (const Tick& tick : m_ticks)
        spoken += tick.text + QLatin1Char(' ');
    setAccessibleDescription(spoken + unit);
    update();
}

void ColorScaleBar::showColoring(const MapColoring& coloring)
{
    std::vector<Tick> ticks;
    if (coloring.colors == MapColors::Signed) {
        for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0})
            ticks.push_back({0.5 * (t + 1.0), (t > 0.0 ? QStringLiteral("+") : QString()) + shortNumberText(t * coloring.high)});
        show(Colors::TwoSided, std::move(ticks), {}, tr("Signed difference in luminance: blue is darker, orange brighter"));
        return;
    }
    for (int i = 0; i <= 4; ++i)
        ticks.push_back({0.25 * i, shortNumberText(coloring.low * std::pow(coloring.high / coloring.low, 0.25 * i))});
    show(Colors::OneSided, std::move(ticks), {}, tr("Luminance, on a logarithmic scale"));
}

void ColorScaleBar::showTint(MapTint tint)
{
    std::vector<Tick> ticks;
    if (tint == MapTint::SolidAngle) {
        for (int i = -3; i <= 3; ++i)
            ticks.push_back({(i + 3) / 6.0, i < 0 ? QStringLiteral("1/%1").arg(1 << -i) : QString::number(1 << i)});
        show(Colors::TwoSided, std::move(ticks), tr("x mean"), tr("Solid angle of a texel over the mean one"));
        return;
    }
    for (int i = 0; i <= 3; ++i)
        ticks.push_back({i / 3.0, QStringLiteral("%1 : 1").arg(1 << i)});
    show(Colors::OneSided, std::move(ticks), {}, tr("Anisotropy: the longer axis of a texel's circle of directions over the shorter"));
}

QSize ColorScaleBar::sizeHint() const { return {240, barHeight + 4 + fontMetrics().height()}; }

QSize ColorScaleBar::minimumSizeHint() const { return {140, sizeHint().height()}; }

void ColorScaleBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QFontMetrics metrics = fontMetrics();
    const int side = metrics.horizontalAdvance(QStringLiteral("0.000")) / 2 + 2;
    const QRect bar(side, 0, std::max(1, width() - 2 * side), barHeight);
    QLinearGradient gradient(bar.left(), 0, bar.right(), 0);
    constexpr int stops = 32;
    for (int i = 0; i <= stops; ++i) {
        const double t = static_cast<double>(i) / stops;
        gradient.setColorAt(t, toQColor(m_colors == Colors::OneSided ? falseColor(t) : signedColor(2.0 * t - 1.0)));
    }
    painter.fillRect(bar, gradient);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(bar.adjusted(0, 0, -1, -1));
    painter.setPen(palette().color(QPalette::Text));
    int end = -1000; // of the number before: those that would touch it are left out
    for (const Tick& tick : m_ticks) {
        const QString text = tick.at > 0.999 && !m_unit.isEmpty() ? tick.text + QLatin1Char(' ') + m_unit : tick.text;
        const int advance = metrics.horizontalAdvance(text);
        const int middle = bar.left() + static_cast<int>(std::lround(tick.at * (bar.width() - 1)));
        const int left = std::clamp(middle - advance / 2, 0, std::max(0, width() - advance));
        if (left < end + 4)
            continue;
        painter.drawLine(middle, bar.bottom() - 2, middle, bar.bottom() + 2);
        painter.drawText(left, barHeight + 4 + metrics.ascent(), text);
        end = left + advance;
    }
}

} // namespace mirrorball::studio
