#include "color_picker.h"

#include "color_button.h"
#include "color_wheel.h"
#include "number_field.h"

#include <QApplication>
#include <QDockWidget>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScreen>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr qsizetype mostColors = 8; ///< of a row
const QString recentKey = QStringLiteral("colors/recent");
const QString keptKey = QStringLiteral("colors/kept");

QVector<glm::dvec3> readColors(const QString& key)
{
    QVector<glm::dvec3> colors;
    for (const QString& line : QSettings().value(key).toStringList()) {
        const QStringList numbers = line.split(u' ');
        if (numbers.size() == 3)
            colors.push_back({numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()});
    }
    return colors;
}

void writeColors(const QString& key, const QVector<glm::dvec3>& colors)
{
    QStringList lines;
    for (const glm::dvec3& color : colors.mid(0, mostColors))
        lines << QStringLiteral("%1 %2 %3").arg(color.r).arg(color.g).arg(color.b);
    QSettings().setValue(key, lines);
}

void putFirst(const QString& key, const glm::dvec3& color)
{
    QVector<glm::dvec3> colors = readColors(key);
    colors.removeAll(color);
    colors.prepend(color);
    writeColors(key, colors);
}

QToolButton* button(const char* iconName, const QString& name, const QString& help)
{
    auto* made = new QToolButton;
    made->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(iconName))));
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(help);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

} // namespace

QVector<glm::dvec3> ColorPicker::recentColors() { return readColors(recentKey); }
QVector<glm::dvec3> ColorPicker::keptColors() { return readColors(keptKey); }

ColorPicker* ColorPicker::of(const QWidget& widget)
{
    for (const QWidget* at = &widget; at; at = at->parentWidget())
        if (auto* picker = at->findChild<ColorPicker*>())
            return picker;
    return nullptr;
}

ColorPicker::ColorPicker(QWidget* parent)
    : QWidget(parent), m_name(new QLabel), m_wheel(new ColorWheel), m_hex(new QLineEdit),
      m_dropper(button("eyedropper", tr("Eyedropper"), tr("Takes the next click's color from anywhere on the screen; Escape ends it"))),
      m_recent(new QHBoxLayout), m_kept(new QHBoxLayout)
{
    setObjectName(QStringLiteral("colorPicker"));
    m_name->setObjectName(QStringLiteral("color.name"));
    m_name->setWordWrap(true);
    m_wheel->setObjectName(QStringLiteral("color.wheel"));
    m_wheel->setAccessibleName(tr("Color wheel"));
    m_wheel->setToolTip(tr("Hue around, saturation from the middle to the rim; arrow keys turn and move"));
    m_hex->setObjectName(QStringLiteral("color.hex"));
    m_hex->setAccessibleName(tr("Hex"));
    m_hex->setToolTip(tr("Red, green and blue as the screen shows them, #rrggbb"));
    m_hex->setMaxLength(7);
    m_dropper->setObjectName(QStringLiteral("color.dropper"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    column->addWidget(m_name);
    column->addWidget(m_wheel, 1);
    makeNumbers();
    makeSwatches();
    connect(m_wheel, &ColorWheel::edited, this, [this](double hue, double saturation) {
        chooseShown(QColor::fromHsvF(static_cast<float>(hue), static_cast<float>(saturation), m_shown.valueF()));
    });
    connect(m_wheel, &ColorWheel::finished, this, &ColorPicker::finish);
    connect(m_dropper, &QToolButton::clicked, this, &ColorPicker::startDropper);
    show({0.0, 0.0, 0.0});
    setEnabled(false);
    m_name->setText(tr("Click a swatch to choose its color here."));
}

NumberField* ColorPicker::addNumber(const char* id, const QString& name, const QString& help, double low, double high, const QString& unit)
{
    auto* field = new NumberField({.low = low,
                                   .high = high,
                                   .sliderLow = low,
                                   .sliderHigh = high,
                                   .initial = low,
                                   .digits = 3,
                                   .step = (high - low) / 100.0,
                                   .unit = unit});
    field->setObjectName(QLatin1String(id));
    field->describe(name, help);
    connect(field, &NumberField::finished, this, &ColorPicker::finish);
    return field;
}

void ColorPicker::makeNumbers()
{
    m_hue = addNumber("color.hue", tr("Hue"), tr("Around the wheel"), 0.0, 360.0, QStringLiteral("°"));
    m_saturation = addNumber("color.saturation", tr("Saturation"), tr("From gray to a pure color"), 0.0, 100.0, QStringLiteral("%"));
    m_value = addNumber("color.value", tr("Value"), tr("From black to the brightest that a screen shows"), 0.0, 100.0, QStringLiteral("%"));
    m_ev = addNumber("color.ev", tr("Intensity"), tr("Stops above what a screen shows: a highlight or a lamp"), 0.0, 10.0, tr("EV"));
    m_kelvin = addNumber("color.kelvin", tr("Kelvin"), tr("The color of a glowing body of this temperature"), 1700.0, 20000.0, tr("K"));
    m_kelvin->setValue(6500.0);
    for (NumberField* field : {m_hue, m_saturation, m_value})
        connect(field, &NumberField::edited, this, [this] {
            chooseShown(QColor::fromHsvF(static_cast<float>(std::min(m_hue->value() / 360.0, 0.9999)),
                                         static_cast<float>(m_saturation->value() / 100.0), static_cast<float>(m_value->value() / 100.0)));
        });
    connect(m_ev, &NumberField::edited, this, [this](double ev) { choose(linearColor({m_shown, ev})); });
    connect(m_kelvin, &NumberField::edited, this,
            [this](double kelvin) { choose(glm::round(blackBody(kelvin) * std::exp2(m_ev->value()) * 1e5) / 1e5); });
    connect(m_hex, &QLineEdit::editingFinished, this, [this] {
        if (const std::optional<QColor> typed = colorOfHex(m_hex->text()); typed && typed->rgb() != m_shown.rgb()) {
            chooseShown(*typed);
            finish();
        }
        m_hex->setText(hexText({m_shown, 0.0}));
    });
    auto* hex = new QHBoxLayout;
    hex->addWidget(m_hex, 1);
    hex->addWidget(m_dropper);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->addRow(tr("Hex"), hex);
    form->addRow(tr("Hue"), m_hue);
    form->addRow(tr("Saturation"), m_saturation);
    form->addRow(tr("Value"), m_value);
    form->addRow(tr("Intensity"), m_ev);
    form->addRow(tr("Kelvin"), m_kelvin);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void ColorPicker::makeSwatches()
{
    auto* keep = button("add", tr("Keep this color"), tr("Puts this color among those that are kept"));
    keep->setObjectName(QStringLiteral("color.keep"));
    connect(keep, &QToolButton::clicked, this, [this] {
        putFirst(keptKey, m_color);
        showSwatches();
    });
    auto* form = new QFormLayout;
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QHBoxLayout* row : {m_recent, m_kept}) {
        row->setSpacing(2);
        row->setAlignment(Qt::AlignLeft);
    }
    auto* kept = new QHBoxLayout;
    kept->addLayout(m_kept, 1);
    kept->addWidget(keep);
    form->addRow(tr("Recent"), m_recent);
    form->addRow(tr("Kept"), kept);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    showSwatches();
}

void ColorPicker::fillRow(QHBoxLayout& row, const QVector<glm::dvec3>& colors, const char* id, const QString& what)
{
    while (QLayoutItem* item = row.takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    for (const glm::dvec3& color : colors) {
        const ColorParts parts = colorParts(color);
        auto* swatch = new QToolButton;
        QPixmap pixmap(18, 18);
        pixmap.fill(parts.shown);
        swatch->setObjectName(QLatin1String(id));
        swatch->setIcon(pixmap);
        swatch->setIconSize({18, 18});
        swatch->setAutoRaise(true);
        swatch->setFocusPolicy(Qt::StrongFocus);
        const QString name = parts.ev > 0.0 ? QStringLiteral("%1 +%2 EV").arg(hexText(parts)).arg(parts.ev, 0, 'f', 1) : hexText(parts);
        swatch->setAccessibleName(what.arg(name));
        swatch->setToolTip(what.arg(name));
        connect(swatch, &QToolButton::clicked, this, [this, color] {
            choose(color);
            finish();
        });
        row.addWidget(swatch);
    }
}

void ColorPicker::showSwatches()
{
    fillRow(*m_recent, recentColors(), "color.recent", tr("Recent color %1"));
    fillRow(*m_kept, keptColors(), "color.kept", tr("Kept color %1"));
}

void ColorPicker::edit(ColorButton& button)
{
    if (m_target)
        disconnect(m_target, nullptr, this, nullptr);
    m_target = &button;
    connect(&button, &ColorButton::colorChanged, this, [this](const glm::dvec3& linear) {
        if (linear != m_color) // undone, or another layer
            show(linear);
    });
    connect(&button, &QObject::destroyed, this, [this] {
        m_target.clear(); // a field that loses the keys below must not write to it
        setEnabled(false);
        m_name->setText(tr("Click a swatch to choose its color here."));
    });
    setEnabled(true);
    m_name->setText(button.accessibleName());
    show(button.color());
    for (QWidget* at = parentWidget(); at; at = at->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(at)) {
            dock->show();
            dock->raise();
        }
}

void ColorPicker::choose(const glm::dvec3& linear)
{
    show(linear);
    if (m_target)
        m_target->pick(linear);
}

void ColorPicker::chooseShown(const QColor& shown)
{
    const double ev = m_ev->value();
    choose(linearColor({shown, ev}));
    m_shown = shown; // black and gray keep the hue that they were given
    m_ev->setValue(ev);
    m_wheel->setHsv(std::max(0.0f, shown.hueF()), shown.saturationF(), shown.valueF());
    m_hue->setValue(360.0 * std::max(0.0f, shown.hueF()));
    m_saturation->setValue(100.0 * shown.saturationF());
}

void ColorPicker::finish()
{
    if (!m_target)
        return;
    m_target->endPick();
    putFirst(recentKey, m_color);
    showSwatches();
}

void ColorPicker::show(const glm::dvec3& linear)
{
    m_color = linear;
    const ColorParts parts = colorParts(linear);
    const float hue = parts.shown.hueF() < 0.0f ? std::max(0.0f, m_shown.hueF()) : parts.shown.hueF();
    m_shown = QColor::fromHsvF(hue, parts.shown.saturationF(), parts.shown.valueF());
    m_wheel->setHsv(hue, parts.shown.saturationF(), parts.shown.valueF());
    m_hue->setValue(360.0 * hue);
    m_saturation->setValue(100.0 * parts.shown.saturationF());
    m_value->setValue(100.0 * parts.shown.valueF());
    m_ev->setValue(parts.ev);
    m_hex->setText(hexText(parts));
}

// ---- the eyedropper ------------------------------------------------------------------------------------------------------------

void ColorPicker::startDropper()
{
    m_isDropping = true;
    setFocus();
    grabMouse(Qt::CrossCursor);
    grabKeyboard();
}

void ColorPicker::mousePressEvent(QMouseEvent* event)
{
    if (!m_isDropping)
        return;
    m_isDropping = false;
    releaseMouse();
    releaseKeyboard();
    if (event->button() == Qt::LeftButton)
        pickFromScreen(event->globalPosition().toPoint());
}

void ColorPicker::keyPressEvent(QKeyEvent* event)
{
    if (!m_isDropping || event->key() != Qt::Key_Escape) {
        QWidget::keyPressEvent(event);
        return;
    }
    m_isDropping = false;
    releaseMouse();
    releaseKeyboard();
}

/// Our own windows can be asked on every system, the rest of the screen where the system allows it.
void ColorPicker::pickFromScreen(const QPoint& global)
{
    QPixmap pixel;
    if (QWidget* widget = QApplication::widgetAt(global))
        pixel = widget->grab(QRect(widget->mapFromGlobal(global), QSize(1, 1)));
    else if (QScreen* screen = QGuiApplication::screenAt(global))
        pixel = screen->grabWindow(0, global.x() - screen->geometry().x(), global.y() - screen->geometry().y(), 1, 1);
    if (pixel.isNull())
        return;
    choose(linearColor({pixel.toImage().pixelColor(0, 0), 0.0}));
    finish();
}

} // namespace mirrorball::studio
