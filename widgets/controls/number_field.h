#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QString>
#include <QTimer>
#include <QWidget>

namespace mirrorball::studio {

enum class Scale { Linear, Logarithmic };

/// How a number is shown and moved.
struct NumberStyle {
    double low = 0.0, high = 1.0;             ///< what can be typed
    double sliderLow = 0.0, sliderHigh = 1.0; ///< what the slider spans; above 0 where it is logarithmic
    Scale scale = Scale::Linear;
    double initial = 0.0; ///< where a double click takes it
    int digits = 4;       ///< significant digits shown
    double step = 0.01;   ///< linear: of a key or a wheel notch; logarithmic: a twentieth of a decade
    QString unit{};
};

/// Text, steps and units of a number. Shift makes steps ten times finer, Ctrl ten times coarser.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(const NumberStyle& style, QWidget* parent = nullptr);
    void stepBy(int steps) override;
    QString textFromValue(double value) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// Keys or wheel moved it; more such moves may follow.
    void stepped();

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    NumberStyle m_style;
};

/// A slider that jumps to a click, and takes a double click as "reset".
class ValueSlider : public QSlider {
    Q_OBJECT

public:
    explicit ValueSlider(QWidget* parent = nullptr);

signals:
    void resetRequested();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
};

/// A number as a slider and a box: drag, type, step, reset.
class NumberField : public QWidget {
    Q_OBJECT

public:
    explicit NumberField(const NumberStyle& style, QWidget* parent = nullptr);
    ~NumberField() override;

    double value() const { return m_value; }
    /// Shows a value; says nothing to anybody.
    void setValue(double value);
    void reset();
    /// Names both controls for tooltips and screen readers.
    void describe(const QString& name, const QString& help);
    ValueSlider* slider() { return m_slider; }
    NumberBox* box() { return m_box; }

signals:
    /// The user moved it to this value.
    void edited(double value);
    /// The user let go: what was edited since is one step.
    void finished();

private:
    void change(double value);
    void finishSoon();
    int sliderPosition(double value) const;
    double sliderValue(int position) const;

    NumberStyle m_style;
    double m_value = 0.0;
    ValueSlider* m_slider;
    NumberBox* m_box;
    QTimer m_rest; ///< runs out when keys, wheel and clicks have come to rest
};

} // namespace mirrorball::studio
