#include "options_form.h"

#include "field_label.h"
#include "file_dialogs.h"
#include "text.h"

#include <QCheckBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

QuietCombo::QuietCombo(QWidget* parent) : QComboBox(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(6);
}

void QuietCombo::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QComboBox::wheelEvent(event);
    else
        event->ignore();
}

OptionsForm::OptionsForm(Document& document, QWidget* parent) : QWidget(parent), m_document(document), m_layout(new QFormLayout(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_layout->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(&m_document, &Document::changed, this, &OptionsForm::refresh);
}

void OptionsForm::addControl(const QString& path, const Field& field, const FieldStyle& style, QWidget* control,
                             std::function<void(const Scene&)> show)
{
    const QString name = style.label.isEmpty() ? labelText(field.name) : style.label;
    control->setObjectName(path);
    auto* number = qobject_cast<NumberField*>(control);
    if (number) {
        number->describe(name, labelText(field.help));
    } else {
        control->setAccessibleName(name);
        control->setToolTip(labelText(field.help));
    }
    auto* label = new FieldLabel(name);
    label->setBuddy(control);
    label->setToolTip(labelText(field.help));
    m_layout->addRow(label, control);
    m_controls.insert(path, control);
    show(m_document.scene());
    m_rows.push_back({control, std::move(show), style.isShown});
    if (style.isShown)
        m_layout->setRowVisible(control, style.isShown(m_document.scene()));
}

void OptionsForm::addText(const QString& path, const Field& field, const FieldStyle& style, const Access<std::string>& access)
{
    auto* control = new QLineEdit(this);
    control->setPlaceholderText(tr("automatic"));
    if (!style.suggestions.isEmpty()) {
        auto* completer = new QCompleter(style.suggestions, control);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        control->setCompleter(completer);
    }
    const QString label = tr("Change %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    connect(control, &QLineEdit::editingFinished, this, [this, control, access, label] {
        const std::string text = control->text().trimmed().toStdString();
        if (text != access.get(m_document.scene()))
            m_document.edit(label, {}, [&](Scene& scene) { access.set(scene, text); });
    });
    if (!style.fileFilter.isEmpty()) {
        control->setPlaceholderText(tr("none"));
        addFileButton(*control, {.purpose = QStringLiteral("layer"), .title = tr("Choose a file"), .filter = style.fileFilter},
                      [this, access, label](const QString& file) {
                          m_document.edit(label, {}, [&](Scene& scene) { access.set(scene, file.toStdString()); });
                      });
    }
    addControl(path, field, style, control, [control, access](const Scene& scene) {
        const QString text = QString::fromStdString(access.get(scene));
        if (control->text() != text)
            control->setText(text);
    });
}

void OptionsForm::setReset(const QString& path, const FieldStyle& style, const Field& field, const std::function<void(Scene&)>& reset)
{
    QWidget* made = control(path);
    auto* label = made ? dynamic_cast<FieldLabel*>(m_layout->labelForField(made)) : nullptr;
    if (!label)
        return;
    const QString text = tr("Reset %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    label->setReset([this, text, reset] { m_document.edit(text, {}, reset); });
}

void OptionsForm::addNumber(const QString& path, const Field& field, const FieldStyle& style, double initial, const Access<double>& access)
{
    const NumberStyle number{.low = field.low,
                             .high = field.high,
                             .sliderLow = style.sliderLow.value_or(field.low),
                             .sliderHigh = style.sliderHigh.value_or(field.high),
                             .scale = style.scale,
                             .initial = initial,
                             .digits = style.digits,
                             .step = style.step,
                             .unit = field.unit == "degrees" ? QStringLiteral("°") : fieldText(field.unit)};
    auto* control = new NumberField(number, this);
    const QString label = tr("Change %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    connect(control, &NumberField::edited, this,
            [this, path, label, access](double value) { m_document.edit(label, path, [&](Scene& scene) { access.set(scene, value); }); });
    connect(control, &NumberField::finished, &m_document, &Document::finishEdit);
    addControl(path, field, style, control, [control, access](const Scene& scene) { control->setValue(access.get(scene)); });
}

void OptionsForm::addWhole(const QString& path, const Field& field, const FieldStyle& style, const Access<int>& access)
{
    const QString label = tr("Change %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    if (!style.choices.isEmpty()) {
        auto* control = new QuietCombo(this);
        for (const int choice : style.choices)
            control->addItem(QString::number(choice) + (field.unit.empty() ? QString() : u' ' + fieldText(field.unit)), choice);
        connect(control, &QComboBox::activated, this, [this, control, label, access](int) {
            m_document.edit(label, {}, [&](Scene& scene) { access.set(scene, control->currentData().toInt()); });
        });
        const QString unit = field.unit.empty() ? QString() : u' ' + fieldText(field.unit);
        addControl(path, field, style, control, [control, access, unit](const Scene& scene) {
            const int value = access.get(scene);
            if (control->findData(value) < 0) // a size that a file brought
                control->addItem(QString::number(value) + unit, value);
            control->setCurrentIndex(control->findData(value));
        });
        return;
    }
    auto* control = new QSpinBox(this);
    control->setRange(static_cast<int>(field.low), static_cast<int>(field.high));
    control->setKeyboardTracking(false);
    control->setFocusPolicy(Qt::StrongFocus);
    if (!field.unit.empty())
        control->setSuffix(u' ' + fieldText(field.unit));
    connect(control, &QSpinBox::valueChanged, this, [this, path, label, access](int value) {
        m_document.edit(label, path, [&](Scene& scene) { access.set(scene, value); });
        m_document.finishEdit();
    });
    addControl(path, field, style, control, [control, access](const Scene& scene) {
        const QSignalBlocker quiet(control);
        control->setValue(access.get(scene));
    });
}

void OptionsForm::addSwitch(const QString& path, const Field& field, const FieldStyle& style, const Access<bool>& access)
{
    auto* control = new QCheckBox(this);
    const QString label = tr("Switch %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    connect(control, &QCheckBox::clicked, this,
            [this, label, access](bool on) { m_document.edit(label, {}, [&](Scene& scene) { access.set(scene, on); }); });
    addControl(path, field, style, control, [control, access](const Scene& scene) { control->setChecked(access.get(scene)); });
}

void OptionsForm::addColor(const QString& path, const Field& field, const FieldStyle& style, const Access<glm::dvec3>& access)
{
    auto* control = new ColorButton(this);
    const QString label = tr("Change %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    connect(control, &ColorButton::edited, this, [this, path, label, access](const glm::dvec3& color) {
        m_document.edit(label, path, [&](Scene& scene) { access.set(scene, color); });
    });
    connect(control, &ColorButton::finished, &m_document, &Document::finishEdit);
    addControl(path, field, style, control, [control, access](const Scene& scene) { control->setColor(access.get(scene)); });
}

void OptionsForm::addChoice(const QString& path, const Field& field, const FieldStyle& style, std::span<const std::string_view> names,
                            const Access<int>& access)
{
    auto* control = new QuietCombo(this);
    for (const std::string_view word : names)
        control->addItem(labelText(word));
    const QString label = tr("Change %1").arg((style.label.isEmpty() ? labelText(field.name) : style.label).toLower());
    connect(control, &QComboBox::activated, this,
            [this, label, access](int index) { m_document.edit(label, {}, [&](Scene& scene) { access.set(scene, index); }); });
    addControl(path, field, style, control, [control, access](const Scene& scene) { control->setCurrentIndex(access.get(scene)); });
}

void OptionsForm::addVector(const QString& path, const Field& field, const FieldStyle& style, const Access<glm::dvec3>& access)
{
    const QString name = style.label.isEmpty() ? labelText(field.name) : style.label;
    const QString label = tr("Change %1").arg(name.toLower());
    const NumberStyle number{.low = field.low, .high = field.high, .digits = style.digits, .step = style.step};
    auto* control = new QWidget(this);
    auto* row = new QHBoxLayout(control);
    row->setContentsMargins(0, 0, 0, 0);
    QVector<NumberBox*> boxes;
    for (int c = 0; c < 3; ++c) {
        auto* box = new NumberBox(number, control);
        box->setMinimumWidth(48);
        box->setAccessibleName(QStringLiteral("%1 %2").arg(name).arg(c + 1));
        box->setToolTip(labelText(field.help));
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, path, label, access, c](double value) {
            m_document.edit(label, path, [&](Scene& scene) {
                glm::dvec3 changed = access.get(scene);
                changed[c] = value;
                access.set(scene, changed);
            });
            m_document.finishEdit();
        });
        row->addWidget(box, 1);
        boxes.push_back(box);
    }
    control->setFocusProxy(boxes.front());
    addControl(path, field, style, control, [boxes, access](const Scene& scene) {
        for (int c = 0; c < 3; ++c) {
            const QSignalBlocker quiet(boxes[c]);
            boxes[c]->setValue(access.get(scene)[c]);
        }
    });
}

void OptionsForm::addRow(QWidget* widget, Span span, std::function<bool(const Scene&)> isShown)
{
    if (span == Span::Whole)
        m_layout->addRow(widget);
    else
        m_layout->addRow(new QLabel, widget);
    if (isShown) {
        m_rows.push_back({widget, {}, isShown});
        m_layout->setRowVisible(widget, isShown(m_document.scene()));
    }
}

void OptionsForm::addHeading(const QString& text)
{
    auto* heading = new QLabel(text);
    heading->setProperty("role", QStringLiteral("heading"));
    m_layout->addRow(heading);
}

void OptionsForm::refresh()
{
    for (const Row& row : m_rows) {
        if (row.show)
            row.show(m_document.scene());
        if (row.isShown)
            m_layout->setRowVisible(row.field, row.isShown(m_document.scene()));
    }
}

} // namespace mirrorball::studio
