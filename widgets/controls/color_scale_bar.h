#pragma once

#include "core/image/map_picture.h"

#include <QString>
#include <QWidget>

#include <vector>

namespace mirrorball::studio {

/// The scale beside a false-color picture: its colors with numbers under them.
class ColorScaleBar : public QWidget {
    Q_OBJECT

public:
    explicit ColorScaleBar(QWidget* parent = nullptr);

    /// The scale of luminances or of signed differences.
    void showColoring(const MapColoring& coloring);
    /// The scale of a tint.
    void showTint(MapTint tint);

    struct Tick {
        double at = 0.0; ///< [0, 1] from the left
        QString text{};
    };
    const std::vector<Tick>& ticks() const { return m_ticks; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    enum class Colors { OneSided, TwoSided };
    void show(Colors colors, std::vector<Tick> ticks, const QString& unit, const QString& help);

    Colors m_colors = Colors::OneSided;
    std::vector<Tick> m_ticks;
    QString m_unit;
};

/// A number in few digits: "0.012", "1.5", "2.3e4".
QString shortNumberText(double value);

} // namespace mirrorball::studio
