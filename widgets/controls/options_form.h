#pragma once

#include "color_button.h"
#include "number_field.h"
#include "widgets/workspace/document.h"

#include "core/scene/scene.h"

#include <QColor>
#include <QComboBox>
#include <QFormLayout>
#include <QHash>
#include <QVector>
#include <QWidget>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace mirrorball::studio {

/// What a field's control knows beyond the field itself. Everything has a sensible default.
struct FieldStyle {
    QString label{};                                 ///< empty: the field's name
    std::optional<double> sliderLow{}, sliderHigh{}; ///< of the slider; empty: the field's range
    Scale scale = Scale::Linear;
    double step = 0.01;
    int digits = 4;
    std::function<bool(const Scene&)> isShown{}; ///< empty: always
    QVector<int> choices{};                      ///< whole numbers that a list offers
    bool isHidden = false;                       ///< no control at all
    bool isText = false;                         ///< a text that is typed; others have controls made elsewhere
    QStringList suggestions{};                   ///< texts that are often wanted
    QStringList names{};                         ///< the texts that there are to choose from; empty: any
    QString fileFilter{};                        ///< a text that names a file: what its chooser shows; empty: no chooser
};
using FieldStyles = std::map<std::string, FieldStyle, std::less<>>;

/// The styles of a struct of which only some fields get a control: those named here.
template <typename Settings>
FieldStyles onlyFields(const FieldStyles& shown)
{
    FieldStyles styles = shown;
    const Settings initial;
    Settings::visitFields(
        initial, [&](const Field& field, const auto&) { styles.try_emplace(std::string(field.name), FieldStyle{.isHidden = true}); });
    return styles;
}

/// A field of a settings struct by its name, for a control that is made elsewhere.
template <typename Settings>
Field fieldNamed(std::string_view name)
{
    Field found{};
    const Settings initial;
    Settings::visitFields(initial, [&](const Field& field, const auto&) {
        if (field.name == name)
            found = field;
    });
    return found;
}

/// A list that lets the wheel scroll the panel it stands in, unless it was clicked into.
class QuietCombo : public QComboBox {
    Q_OBJECT

public:
    explicit QuietCombo(QWidget* parent = nullptr);

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// Controls for the fields of settings structs, built from their visitFields: what a field is called, its range, unit and help are spelled
/// once, in core. Each control is named by its field's path ("material.specular.exponent"), which is also the key that merges a drag.
class OptionsForm : public QWidget {
    Q_OBJECT

public:
    explicit OptionsForm(Document& document, QWidget* parent = nullptr);

    /// Adds a row for every field that has a control. Where a struct's fields stand in two places, one place names its few by onlyFields()
    /// and the other hides those, so that a field that is added to the struct appears once.
    /// @param path    of the struct in the scene: "material.specular"
    /// @param select  [](auto& scene) -> auto& { return scene.material.specular; }, for a Scene and a const Scene alike
    /// @throws std::logic_error for the style of a field that the struct does not have
    template <typename Select>
    void addFields(const std::string& path, Select select, const FieldStyles& styles = {})
    {
        using Settings = std::remove_cvref_t<decltype(select(std::declval<Scene&>()))>;
        const Settings initial;
        size_t styled = 0;
        Settings::visitFields(initial, [&](const Field& field, const auto& value) {
            using T = std::remove_cvref_t<decltype(value)>;
            styled += styles.count(field.name);
            const auto found = styles.find(field.name);
            const FieldStyle style = found == styles.end() ? FieldStyle{} : found->second;
            if (style.isHidden)
                return;
            const std::string name(field.name);
            const Access<T> access{[select, name](const Scene& scene) -> T { return member<T>(select(scene), name); },
                                   [select, name](Scene& scene, const T& to) { member<T>(select(scene), name) = to; }};
            const QString fieldPath = QString::fromStdString(path + "." + name);
            if constexpr (std::is_same_v<T, double>)
                addNumber(fieldPath, field, style, value, access);
            else if constexpr (std::is_same_v<T, int>)
                addWhole(fieldPath, field, style, access);
            else if constexpr (std::is_same_v<T, bool>)
                addSwitch(fieldPath, field, style, access);
            else if constexpr (std::is_same_v<T, glm::dvec3>)
                field.name == "color" ? addColor(fieldPath, field, style, access) : addVector(fieldPath, field, style, access);
            else if constexpr (std::is_same_v<T, std::string>) {
                if (style.isText)
                    addText(fieldPath, field, style, access);
            } else if constexpr (std::is_enum_v<T>)
                addChoice(fieldPath, field, style, words(value),
                          {[access](const Scene& scene) { return static_cast<int>(access.get(scene)); },
                           [access](Scene& scene, const int& to) { access.set(scene, static_cast<T>(to)); }});
            setReset(fieldPath, style, field, [access, value](Scene& scene) { access.set(scene, value); });
        });
        if (styled != styles.size())
            throw std::logic_error("a style is given for a field that " + path + " does not have");
    }

    /// A control made elsewhere, as a row like the others. @param show shows the scene's value in it
    void addControl(const QString& path, const Field& field, const FieldStyle& style, QWidget* control,
                    std::function<void(const Scene&)> show);
    /// A row of its own between the fields, where the controls are, or across the whole width.
    enum class Span { Controls, Whole };
    void addRow(QWidget* widget, Span span, std::function<bool(const Scene&)> isShown = {});
    /// A heading above the rows that follow.
    void addHeading(const QString& text);
    /// The control of a field, or null.
    QWidget* control(const QString& path) const { return m_controls.value(path); }
    QFormLayout* layout() const { return m_layout; }
    Document& document() const { return m_document; }

    /// Reads and writes one field of a scene.
    template <typename T>
    struct Access {
        std::function<T(const Scene&)> get;
        std::function<void(Scene&, const T&)> set;
    };

private:
    template <typename T, typename Settings>
    static auto& member(Settings& settings, const std::string& name)
    {
        using Member = std::conditional_t<std::is_const_v<Settings>, const T, T>;
        Member* found = nullptr;
        std::remove_const_t<Settings>::visitFields(settings, [&](const Field& field, auto& value) {
            if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(value)>>, T>)
                if (field.name == name)
                    found = &value;
        });
        return *found;
    }

    void addNumber(const QString& path, const Field& field, const FieldStyle& style, double initial, const Access<double>& access);
    void addWhole(const QString& path, const Field& field, const FieldStyle& style, const Access<int>& access);
    void addSwitch(const QString& path, const Field& field, const FieldStyle& style, const Access<bool>& access);
    void addColor(const QString& path, const Field& field, const FieldStyle& style, const Access<glm::dvec3>& access);
    void addChoice(const QString& path, const Field& field, const FieldStyle& style, std::span<const std::string_view> names,
                   const Access<int>& access);
    void addText(const QString& path, const Field& field, const FieldStyle& style, const Access<std::string>& access);
    void addVector(const QString& path, const Field& field, const FieldStyle& style, const Access<glm::dvec3>& access);
    /// What a double click on a field's label does.
    void setReset(const QString& path, const FieldStyle& style, const Field& field, const std::function<void(Scene&)>& reset);
    void refresh();

    struct Row {
        QWidget* field;
        std::function<void(const Scene&)> show; ///< the scene's value
        std::function<bool(const Scene&)> isShown;
    };
    Document& m_document;
    QFormLayout* m_layout;
    QVector<Row> m_rows;
    QHash<QString, QWidget*> m_controls;
};

} // namespace mirrorball::studio
