#pragma once

#include "curve_editor.h"
#include "gradient_editor.h"
#include "item_chooser.h"
#include "number_field.h"
#include "options_form.h"
#include "text.h"

#include "core/spheremap/math/curve_table.h"
#include "core/spheremap/math/gradient_table.h"
#include "core/spheremap/strokes/stroke.h"

#include <QFormLayout>
#include <QVector>
#include <QWidget>

#include <any>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace mirrorball::studio {

/// Lists that a form shows item by item.
template <typename T>
inline constexpr bool isListOfSettings = false;
template <typename Item>
inline constexpr bool isListOfSettings<std::vector<Item>> = !std::is_same_v<Item, Stroke> && requires(const Item& item)
{
    Item::visitFields(item, [](const Field&, const auto&) {});
};

/// Controls for the fields of one settings struct, whichever it is at the moment: a layer's parameters, a brush. Built from its visitFields
/// as OptionsForm is, but over a value that is handed in instead of the scene. Each control is named by its field.
class SettingsForm : public QWidget {
    Q_OBJECT

public:
    /// What an edit does: a label for the undo step, a key that merges a drag, and the change itself.
    template <typename Settings>
    using Edit = std::function<void(const QString& label, const QString& key, const std::function<void(Settings&)>& change)>;

    explicit SettingsForm(QWidget* parent = nullptr);
    ~SettingsForm() override;

    /// Removes all controls and makes those of this struct.
    /// @param isUsed  whether a field, by its name, has an effect on what the struct says; others are hidden. Null: all have
    template <typename Settings>
    void build(const Settings& value, const Edit<Settings>& edit, const FieldStyles& styles = {},
               const std::function<bool(const Settings&, std::string_view)>& isUsed = {})
    {
        clear();
        m_styles = styles;
        if (isUsed)
            m_isUsed = [isUsed](const std::any& settings, std::string_view name) {
                return isUsed(*std::any_cast<const Settings*>(settings), name);
            };
        const Settings initial;
        Settings::visitFields(initial, [&](const Field& field, const auto& preset) {
            using T = std::remove_cvref_t<decltype(preset)>;
            const auto found = styles.find(field.name);
            const FieldStyle style = found == styles.end() ? FieldStyle{} : found->second;
            if (style.isHidden)
                return;
            const std::string name(field.name);
            const QString label = tr("Change %1").arg(labelOf(field, style).toLower());
            const auto set = [edit, name, label](const T& to) {
                edit(label, QString::fromStdString(name), [&](Settings& settings) { assign(settings, name, to); });
            };
            const auto get = [name](const std::any& settings) { return valueOf<T>(*std::any_cast<const Settings*>(settings), name); };
            addField(field, style, preset, std::function<void(const T&)>(set), std::function<T(const std::any&)>(get));
            setReset(field, [this, set, preset] {
                set(preset);
                emit finished();
            });
        });
        show(value);
    }

    /// Shows a value of the struct that the form was built for.
    template <typename Settings>
    void show(const Settings& value)
    {
        const std::any settings = &value;
        for (const auto& row : m_rows)
            row(settings);
        showUsed(settings);
    }

    /// Shows an item of a list.
    void chooseItem(const QString& list, int item);
    /// The control of a field, or null.
    QWidget* control(const QString& name) const { return findChild<QWidget*>(name); }

signals:
    /// The user let go of a control: what was edited since is one step.
    void finished();
    /// Another item of a list is shown, by its field's name.
    void itemChosen(const QString& list, int item);

private:
    template <typename T, typename Settings>
    static void assign(Settings& settings, const std::string& name, const T& to)
    {
        Settings::visitFields(settings, [&](const Field& field, auto& value) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, T>)
                if (field.name == name)
                    value = to;
        });
    }
    template <typename T, typename Settings>
    static T valueOf(const Settings& settings, const std::string& name)
    {
        T result{};
        Settings::visitFields(settings, [&](const Field& field, const auto& value) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, T>)
                if (field.name == name)
                    result = value;
        });
        return result;
    }

    template <typename T>
    void addField(const Field& field, const FieldStyle& style, const T& preset, const std::function<void(const T&)>& set,
                  const std::function<T(const std::any&)>& get)
    {
        if constexpr (std::is_same_v<T, double>) {
            addNumber(field, style, preset, set, get);
        } else if constexpr (std::is_same_v<T, int>) {
            addWhole(field, style, set, get);
        } else if constexpr (std::is_same_v<T, bool>) {
            addSwitch(field, style, set, get);
        } else if constexpr (std::is_same_v<T, glm::dvec3>) {
            addColor(field, style, set, get);
        } else if constexpr (std::is_same_v<T, std::string>) {
            addText(field, style, set, get);
        } else if constexpr (std::is_same_v<T, std::vector<GradientStop>>) {
            addGradient(field, style, set, get);
        } else if constexpr (std::is_same_v<T, std::vector<CurvePoint>>) {
            addCurve(field, style, set, get);
        } else if constexpr (isListOfSettings<T>) {
            addItems(field, style, set, get);
        } else if constexpr (std::is_enum_v<T>) {
            addChoice(
                field, style, words(preset), [set](const int& index) { set(static_cast<T>(index)); },
                [get](const std::any& settings) { return static_cast<int>(get(settings)); });
        }
    }

    /// A list of structs: which one, and controls for its fields below.
    template <typename Item>
    void addItems(const Field& field, const FieldStyle& style, const std::function<void(const std::vector<Item>&)>& set,
                  const std::function<std::vector<Item>(const std::any&)>& get)
    {
        auto* chooser = new ItemChooser(static_cast<int>(field.low), static_cast<int>(field.high), this);
        auto* form = new SettingsForm(this);
        const auto items = std::make_shared<std::vector<Item>>();
        const auto show = [chooser, form, items] {
            chooser->setCount(static_cast<int>(items->size()));
            form->setVisible(!items->empty());
            if (!items->empty())
                form->SettingsForm::show((*items)[static_cast<size_t>(chooser->chosen())]);
        };
        form->build<Item>(
            Item{},
            [chooser, items, set](const QString&, const QString&, const std::function<void(Item&)>& change) {
                std::vector<Item> changed = *items;
                if (chooser->chosen() < 0)
                    return;
                change(changed[static_cast<size_t>(chooser->chosen())]);
                set(changed);
            },
            m_styles);
        connect(form, &SettingsForm::finished, this, &SettingsForm::finished);
        connect(chooser, &ItemChooser::chosenChanged, form, show);
        connect(chooser, &ItemChooser::chosenChanged, this,
                [this, chooser, name = std::string(field.name)] { emit itemChosen(QString::fromStdString(name), chooser->chosen()); });
        connect(chooser, &ItemChooser::addRequested, this, [this, chooser, items, set] {
            std::vector<Item> changed = *items;
            const int at = chooser->chosen() + 1;
            changed.insert(changed.begin() + at, at > 0 ? changed[static_cast<size_t>(at - 1)] : Item{});
            set(changed);
            emit finished();
            chooser->choose(at);
        });
        connect(chooser, &ItemChooser::removeRequested, this, [this, chooser, items, set] {
            std::vector<Item> changed = *items;
            changed.erase(changed.begin() + chooser->chosen());
            set(changed);
            emit finished();
        });
        addItemRows(field, style, chooser, form, [items, get, show](const std::any& settings) {
            *items = get(settings);
            show();
        });
    }
    void addItemRows(const Field& field, const FieldStyle& style, ItemChooser* chooser, SettingsForm* form,
                     std::function<void(const std::any&)> show);

    void clear();
    void showUsed(const std::any& settings);
    void setReset(const Field& field, const std::function<void()>& reset);
    static QString labelOf(const Field& field, const FieldStyle& style);
    void addRow(const Field& field, const FieldStyle& style, QWidget* control, std::function<void(const std::any&)> show);
    void addNumber(const Field&, const FieldStyle&, double preset, const std::function<void(const double&)>& set,
                   const std::function<double(const std::any&)>& get);
    void addWhole(const Field&, const FieldStyle&, const std::function<void(const int&)>& set,
                  const std::function<int(const std::any&)>& get);
    void addSwitch(const Field&, const FieldStyle&, const std::function<void(const bool&)>& set,
                   const std::function<bool(const std::any&)>& get);
    void addColor(const Field&, const FieldStyle&, const std::function<void(const glm::dvec3&)>& set,
                  const std::function<glm::dvec3(const std::any&)>& get);
    void addText(const Field&, const FieldStyle&, const std::function<void(const std::string&)>& set,
                 const std::function<std::string(const std::any&)>& get);
    void addName(const Field&, const FieldStyle&, const std::function<void(const std::string&)>& set,
                 const std::function<std::string(const std::any&)>& get);
    void addChoice(const Field&, const FieldStyle&, std::span<const std::string_view> names, const std::function<void(const int&)>& set,
                   const std::function<int(const std::any&)>& get);
    void addGradient(const Field&, const FieldStyle&, const std::function<void(const std::vector<GradientStop>&)>& set,
                     const std::function<std::vector<GradientStop>(const std::any&)>& get);
    void addCurve(const Field&, const FieldStyle&, const std::function<void(const std::vector<CurvePoint>&)>& set,
                  const std::function<std::vector<CurvePoint>(const std::any&)>& get);

    QFormLayout* m_layout;
    FieldStyles m_styles{}; ///< of the struct at hand, for its parts too
    QVector<std::function<void(const std::any&)>> m_rows;
    QVector<std::pair<std::string, QWidget*>> m_fields; ///< controls by their fields' names
    std::function<bool(const std::any&, std::string_view)> m_isUsed{};
};

} // namespace mirrorball::studio
