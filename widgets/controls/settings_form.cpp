#include "settings_form.h"

#include "disconnect_children.h"
#include "field_label.h"
#include "file_dialogs.h"

#include "core/spheremap/layers/adjust.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

namespace mirrorball::studio {

SettingsForm::SettingsForm(QWidget* parent) : QWidget(parent), m_layout(new QFormLayout(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_layout->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_layout->setRowWrapPolicy(QFormLayout::DontWrapRows);
}

SettingsForm::~SettingsForm() { disconnectChildren(*this); }

// A control may be what asked for this, by its signal: rows go when it has returned.
void SettingsForm::clear()
{
    m_rows.clear();
    m_fields.clear();
    m_isUsed = {};
    while (m_layout->rowCount() > 0) {
        const QFormLayout::TakeRowResult row = m_layout->takeRow(0);
        for (QLayoutItem* item : {row.labelItem, row.fieldItem}) {
            if (!item)
                continue;
            if (QWidget* widget = item->widget()) {
                widget->hide();
                widget->setObjectName({});
                widget->disconnect(this);
                widget->deleteLater();
            }
            delete item;
        }
    }
}

void SettingsForm::showUsed(const std::any& settings)
{
    if (m_isUsed)
        for (const auto& [name, control] : m_fields)
            m_layout->setRowVisible(control, m_isUsed(settings, name));
}

void SettingsForm::setReset(const Field& field, const std::function<void()>& reset)
{
    for (const auto& [name, control] : m_fields)
        if (name == field.name)
            if (auto* label = dynamic_cast<FieldLabel*>(m_layout->labelForField(control)))
                label->setReset(reset);
}

QString SettingsForm::labelOf(const Field& field, const FieldStyle& style)
{
    if (!style.label.isEmpty())
        return style.label;
    QString name = labelText(field.name);
    return name.replace(u'-', u' ').replace(u'_', u' ');
}

void SettingsForm::addRow(const Field& field, const FieldStyle& style, QWidget* control, std::function<void(const std::any&)> show)
{
    const QString name = labelOf(field, style), help = labelText(field.help);
    control->setObjectName(toQString(field.name));
    if (auto* number = qobject_cast<NumberField*>(control)) {
        number->describe(name, help);
    } else {
        control->setAccessibleName(name);
        control->setToolTip(help);
    }
    auto* label = new FieldLabel(name);
    label->setBuddy(control);
    label->setToolTip(help);
    m_layout->addRow(label, control);
    m_fields.push_back({std::string(field.name), control});
    m_rows.push_back(std::move(show));
}

void SettingsForm::addItemRows(const Field& field, const FieldStyle& style, ItemChooser* chooser, SettingsForm* form,
                               std::function<void(const std::any&)> show)
{
    chooser->setObjectName(toQString(field.name));
    chooser->describe(labelOf(field, style), labelText(field.help));
    form->setObjectName(toQString(field.name) + QStringLiteral("Form"));
    auto* label = new QLabel(labelOf(field, style));
    label->setToolTip(labelText(field.help));
    m_layout->addRow(label, chooser);
    m_layout->addRow(form);
    m_rows.push_back(std::move(show));
}

void SettingsForm::chooseItem(const QString& list, int item)
{
    if (auto* chooser = findChild<ItemChooser*>(list))
        chooser->choose(item);
}

void SettingsForm::addNumber(const Field& field, const FieldStyle& style, double preset, const std::function<void(const double&)>& set,
                             const std::function<double(const std::any&)>& get)
{
    const double low = style.sliderLow.value_or(std::max(field.low, -1e6)), high = style.sliderHigh.value_or(std::min(field.high, 1e6));
    const NumberStyle number{.low = field.low,
                             .high = field.high,
                             .sliderLow = low,
                             .sliderHigh = high,
                             .scale = style.scale,
                             .initial = preset,
                             .digits = style.digits,
                             .step = field.unit == "degrees" ? 1.0 : style.step,
                             .unit = field.unit == "degrees" ? QStringLiteral("°") : QString()};
    auto* control = new NumberField(number, this);
    connect(control, &NumberField::edited, this, [set](double value) { set(value); });
    connect(control, &NumberField::finished, this, &SettingsForm::finished);
    addRow(field, style, control, [control, get](const std::any& settings) { control->setValue(get(settings)); });
}

void SettingsForm::addWhole(const Field& field, const FieldStyle& style, const std::function<void(const int&)>& set,
                            const std::function<int(const std::any&)>& get)
{
    auto* control = new QSpinBox(this);
    control->setRange(static_cast<int>(field.low), static_cast<int>(field.high));
    control->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    control->setKeyboardTracking(false);
    control->setFocusPolicy(Qt::StrongFocus);
    connect(control, &QSpinBox::valueChanged, this, [this, set](int value) {
        set(value);
        emit finished();
    });
    addRow(field, style, control, [control, get](const std::any& settings) {
        const QSignalBlocker quiet(control);
        control->setValue(get(settings));
    });
}

void SettingsForm::addSwitch(const Field& field, const FieldStyle& style, const std::function<void(const bool&)>& set,
                             const std::function<bool(const std::any&)>& get)
{
    auto* control = new QCheckBox(this);
    connect(control, &QCheckBox::clicked, this, [this, set](bool on) {
        set(on);
        emit finished();
    });
    addRow(field, style, control, [control, get](const std::any& settings) { control->setChecked(get(settings)); });
}

void SettingsForm::addColor(const Field& field, const FieldStyle& style, const std::function<void(const glm::dvec3&)>& set,
                            const std::function<glm::dvec3(const std::any&)>& get)
{
    auto* control = new ColorButton(this);
    connect(control, &ColorButton::edited, this, [set](const glm::dvec3& color) { set(color); });
    connect(control, &ColorButton::finished, this, &SettingsForm::finished);
    addRow(field, style, control, [control, get](const std::any& settings) { control->setColor(get(settings)); });
}

void SettingsForm::addText(const Field& field, const FieldStyle& style, const std::function<void(const std::string&)>& set,
                           const std::function<std::string(const std::any&)>& get)
{
    if (!style.names.isEmpty()) {
        addName(field, style, set, get);
        return;
    }
    auto* control = new QLineEdit(this);
    if (!style.suggestions.isEmpty()) {
        auto* completer = new QCompleter(style.suggestions, control);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        completer->setFilterMode(Qt::MatchContains);
        control->setCompleter(completer);
        control->setPlaceholderText(style.suggestions.first());
    }
    connect(control, &QLineEdit::editingFinished, this, [this, control, set] {
        set(control->text().toStdString());
        emit finished();
    });
    addRow(field, style, control, [control, get](const std::any& settings) {
        const QString text = QString::fromStdString(get(settings));
        if (control->text() != text)
            control->setText(text);
    });
    if (!style.suggestions.isEmpty()) {
        QAction* offer = control->addAction(QIcon(QStringLiteral(":/icons/down.svg")), QLineEdit::TrailingPosition);
        offer->setObjectName(QStringLiteral("chooseSuggestion"));
        offer->setToolTip(tr("Choose one that is built in"));
        connect(offer, &QAction::triggered, this, [this, control, set, suggestions = style.suggestions] {
            QMenu menu;
            for (const QString& suggestion : suggestions)
                menu.addAction(suggestion);
            if (const QAction* chosen = menu.exec(control->mapToGlobal(QPoint(0, control->height())))) {
                set(chosen->text().toStdString());
                emit finished();
            }
        });
    }
    if (style.fileFilter.isEmpty())
        return;
    addFileButton(*control, {.purpose = QStringLiteral("layer"), .title = tr("Choose a file"), .filter = style.fileFilter},
                  [this, set](const QString& path) {
                      set(path.toStdString());
                      emit finished();
                  });
}

void SettingsForm::addName(const Field& field, const FieldStyle& style, const std::function<void(const std::string&)>& set,
                           const std::function<std::string(const std::any&)>& get)
{
    auto* control = new QuietCombo(this);
    for (const QString& name : style.names)
        control->addItem(labelText(name.toStdString()), name);
    connect(control, &QComboBox::activated, this, [this, control, set](int) {
        set(control->currentData().toString().toStdString());
        emit finished();
    });
    addRow(field, style, control, [control, get](const std::any& settings) {
        const QString name = QString::fromStdString(get(settings));
        if (control->findData(name) < 0) // of a file
            control->addItem(name, name);
        control->setCurrentIndex(control->findData(name));
    });
}

void SettingsForm::addChoice(const Field& field, const FieldStyle& style, std::span<const std::string_view> names,
                             const std::function<void(const int&)>& set, const std::function<int(const std::any&)>& get)
{
    auto* control = new QuietCombo(this);
    for (const std::string_view word : names)
        control->addItem(labelText(word));
    connect(control, &QComboBox::activated, this, [this, set](int index) {
        set(index);
        emit finished();
    });
    addRow(field, style, control, [control, get](const std::any& settings) { control->setCurrentIndex(get(settings)); });
}

void SettingsForm::addGradient(const Field& field, const FieldStyle& style,
                               const std::function<void(const std::vector<GradientStop>&)>& set,
                               const std::function<std::vector<GradientStop>(const std::any&)>& get)
{
    auto* control = new GradientEditor(this);
    connect(control, &GradientEditor::edited, this, [set](const std::vector<GradientStop>& stops) { set(stops); });
    connect(control, &GradientEditor::finished, this, &SettingsForm::finished);
    addRow(field, style, control, [control, get](const std::any& settings) { control->setStops(get(settings)); });
}

/// Whatever has a curve and channels shows the curve in their color.
void SettingsForm::addCurve(const Field& field, const FieldStyle& style, const std::function<void(const std::vector<CurvePoint>&)>& set,
                            const std::function<std::vector<CurvePoint>(const std::any&)>& get)
{
    auto* control = new CurveEditor(this);
    connect(control, &CurveEditor::edited, this, [set](const std::vector<CurvePoint>& points) { set(points); });
    connect(control, &CurveEditor::finished, this, &SettingsForm::finished);
    control->setObjectName(toQString(field.name));
    control->setAccessibleName(labelOf(field, style));
    m_layout->addRow(control); // across the form: the larger the plot, the finer the mouse
    m_rows.push_back([control, get](const std::any& settings) {
        if (const auto* curves = std::any_cast<const CurvesLayer*>(&settings))
            control->setChannels((*curves)->channels);
        control->setPoints(get(settings));
    });
}

} // namespace mirrorball::studio
