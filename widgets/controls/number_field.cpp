#include "number_field.h"

#include "disconnect_children.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLocale>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr int sliderSteps = 10000;
constexpr double logStep = 0.05; // decades

double stepFactor()
{
    const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
    return keys.testFlag(Qt::ShiftModifier) ? 0.1 : keys.testFlag(Qt::ControlModifier) ? 10.0 : 1.0;
}

} // namespace

NumberBox::NumberBox(const NumberStyle& style, QWidget* parent) : QDoubleSpinBox(parent), m_style(style)
{
    setDecimals(9); // what is shown is textFromValue()'s affair
    setRange(style.low, style.high);
    setSuffix(style.unit.isEmpty() ? QString() : u' ' + style.unit);
    setKeyboardTracking(false);
    setAccelerated(true);
    setFocusPolicy(Qt::StrongFocus);
    setAlignment(Qt::AlignRight);
}

void NumberBox::stepBy(int steps)
{
    const double wanted = m_style.scale == Scale::Logarithmic
                              ? std::max(value(), m_style.sliderLow) * std::pow(10.0, logStep * steps * stepFactor())
                              : value() + m_style.step * steps * stepFactor();
    setValue(std::clamp(wanted, minimum(), maximum()));
    selectAll();
    emit stepped();
}

QString NumberBox::textFromValue(double value) const
{
    const double rounded = std::abs(value) < 1e-12 ? 0.0 : value;
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    const double size = std::abs(rounded);
    const int whole = size >= 1.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
    QString text = plain.toString(rounded, 'f', std::clamp(m_style.digits - whole, 0, 9));
    if (text.contains(plain.decimalPoint())) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(plain.decimalPoint()))
            text.chop(plain.decimalPoint().size());
    }
    return text;
}

QSize NumberBox::sizeHint() const
{
    const QString widest = QStringLiteral("-1000000").left(m_style.digits + 3);
    const int unit = std::max(fontMetrics().horizontalAdvance(suffix()),
                              fontMetrics().horizontalAdvance(QStringLiteral(" °"))); // boxes in a column alike
    return {fontMetrics().horizontalAdvance(widest) + unit + 34, QDoubleSpinBox::sizeHint().height()};
}

// A wheel over a panel scrolls the panel, unless the box was clicked into.
void NumberBox::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent)
{
    setRange(0, sliderSteps);
    setSingleStep(sliderSteps / 200);
    setPageStep(sliderSteps / 20);
    setFocusPolicy(Qt::StrongFocus);
}

void ValueSlider::mousePressEvent(QMouseEvent* event)
{
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (event->button() == Qt::LeftButton && !handle.contains(event->position().toPoint())) {
        const int span = width() - handle.width();
        setSliderDown(true);
        setSliderPosition(
            QStyle::sliderValueFromPosition(minimum(), maximum(), event->position().toPoint().x() - handle.width() / 2, span));
    }
    QSlider::mousePressEvent(event);
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit resetRequested();
}

void ValueSlider::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

NumberField::NumberField(const NumberStyle& style, QWidget* parent)
    : QWidget(parent), m_style(style), m_slider(new ValueSlider(this)), m_box(new NumberBox(style, this))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_slider, 1);
    row->addWidget(m_box);
    setFocusProxy(m_box);

    m_rest.setSingleShot(true);
    m_rest.setInterval(QApplication::doubleClickInterval());
    connect(&m_rest, &QTimer::timeout, this, &NumberField::finished);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        change(sliderValue(position));
        if (!m_slider->isSliderDown())
            finishSoon(); // keys or wheel
    });
    connect(m_slider, &QSlider::sliderPressed, &m_rest, &QTimer::stop);
    connect(m_slider, &QSlider::sliderReleased, this, &NumberField::finished);
    connect(m_slider, &ValueSlider::resetRequested, this, &NumberField::reset);
    connect(m_box, &QDoubleSpinBox::valueChanged, this, [this](double value) { change(value); });
    connect(m_box, &NumberBox::stepped, this, &NumberField::finishSoon);
    connect(m_box, &QDoubleSpinBox::editingFinished, this, &NumberField::finished);
    setValue(style.initial);
}

NumberField::~NumberField() { disconnectChildren(*this); }

void NumberField::setValue(double value)
{
    m_value = value;
    const QSignalBlocker quietSlider(m_slider), quietBox(m_box);
    if (!m_slider->isSliderDown())
        m_slider->setValue(sliderPosition(value));
    if (m_box->value() != value)
        m_box->setValue(value);
}

void NumberField::reset()
{
    change(m_style.initial);
    emit finished();
}

void NumberField::describe(const QString& name, const QString& help)
{
    m_slider->setAccessibleName(name);
    m_box->setAccessibleName(name);
    m_slider->setToolTip(tr("%1. Double-click to reset.").arg(help));
    m_box->setToolTip(tr("%1. Arrow keys step; Shift: finer, Ctrl: coarser.").arg(help));
}

void NumberField::change(double value)
{
    if (value == m_value)
        return;
    setValue(value);
    emit edited(value);
}

void NumberField::finishSoon() { m_rest.start(); }

int NumberField::sliderPosition(double value) const
{
    const double within = std::clamp(value, m_style.sliderLow, m_style.sliderHigh);
    const double fraction = m_style.scale == Scale::Logarithmic
                                ? std::log(within / m_style.sliderLow) / std::log(m_style.sliderHigh / m_style.sliderLow)
                                : (within - m_style.sliderLow) / (m_style.sliderHigh - m_style.sliderLow);
    return static_cast<int>(std::lround(fraction * sliderSteps));
}

/// Rounded to the digits that are shown, so that the file holds what the eye read.
double NumberField::sliderValue(int position) const
{
    const double fraction = static_cast<double>(position) / sliderSteps;
    const double exact = m_style.scale == Scale::Logarithmic
                             ? m_style.sliderLow * std::pow(m_style.sliderHigh / m_style.sliderLow, fraction)
                             : m_style.sliderLow + fraction * (m_style.sliderHigh - m_style.sliderLow);
    if (exact == 0.0)
        return 0.0;
    const double reach =
        m_style.scale == Scale::Logarithmic ? std::abs(exact) : std::max(std::abs(m_style.sliderHigh), std::abs(m_style.sliderLow));
    const double unit = std::pow(10.0, std::floor(std::log10(reach)) - (m_style.digits - 1));
    // Through the decimal text, so that 0.3 is the double that "0.3" reads as.
    return QString::number(std::round(exact / unit) * unit, 'g', 12).toDouble();
}

} // namespace mirrorball::studio
