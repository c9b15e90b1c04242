#pragma once

#include "color_parts.h"

#include <QPointer>
#include <QVector>
#include <QWidget>

#include <glm/glm.hpp>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace mirrorball::studio {

class ColorButton;
class ColorWheel;
class NumberField;

/// Chooses the color of the swatch that was clicked last: a wheel of hue and saturation, sliders, hex, stops above 1, color temperature,
/// swatches that are kept and colors that were used, and an eyedropper for the whole screen. Stands in a dock; every drag is one step of
/// undo of whatever the swatch belongs to.
class ColorPicker : public QWidget {
    Q_OBJECT

public:
    explicit ColorPicker(QWidget* parent = nullptr);

    /// The picker of the window that a widget belongs to, or null.
    static ColorPicker* of(const QWidget& widget);
    /// Shows and changes this swatch from now on, and comes to the front.
    void edit(ColorButton& button);
    ColorButton* target() const { return m_target; }
    const glm::dvec3& color() const { return m_color; }
    /// What was chosen lately, the newest first; kept between runs.
    static QVector<glm::dvec3> recentColors();
    /// What was put aside; kept between runs.
    static QVector<glm::dvec3> keptColors();

    QSize sizeHint() const override { return {300, 420}; }

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    NumberField* addNumber(const char* id, const QString& name, const QString& help, double low, double high, const QString& unit);
    void makeNumbers();
    void makeSwatches();
    void choose(const glm::dvec3& linear);
    void chooseShown(const QColor& shown);
    void finish();
    void show(const glm::dvec3& linear);
    void showSwatches();
    void fillRow(QHBoxLayout& row, const QVector<glm::dvec3>& colors, const char* id, const QString& what);
    void startDropper();
    void pickFromScreen(const QPoint& global);

    QPointer<ColorButton> m_target;
    glm::dvec3 m_color{0.0};
    QColor m_shown{}; ///< keeps hue and saturation where black and gray have none
    QLabel* m_name;
    ColorWheel* m_wheel;
    NumberField *m_hue, *m_saturation, *m_value, *m_ev, *m_kelvin;
    QLineEdit* m_hex;
    QToolButton* m_dropper;
    QHBoxLayout *m_recent, *m_kept;
    bool m_isDropping = false; ///< the next click anywhere picks
};

} // namespace mirrorball::studio
