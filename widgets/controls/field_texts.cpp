#include "field_texts.h"

#include "core/base/field_checks.h"
#include "core/scene/material_presets.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"
#include "core/shading/conductor.h"
#include "core/spheremap/document/layer.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_document.h"

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace mirrorball::studio {

namespace {

class Collector {
public:
    template <typename T>
    void operator()(const Field& field, const T& value)
    {
        add(field.name);
        add(field.help);
        add(field.unit);
        collect(value);
    }

    template <typename T>
    void collect(const T& value)
    {
        if constexpr (std::is_enum_v<T>)
            for (const std::string_view word : words(value))
                add(word);
        else if constexpr (hasFields<T>)
            T::visitFields(value, *this);
    }
    template <typename T>
    void collect(const std::vector<T>&)
    {
        collect(T{});
    }
    template <typename T>
    void collect(const std::optional<T>&)
    {
        collect(T{});
    }
    template <typename... Kinds>
    void collect(const std::variant<Kinds...>&)
    {
        (collect(Kinds{}), ...);
    }

    void add(std::string_view text)
    {
        if (!text.empty())
            texts.emplace(text);
    }

    std::set<std::string> texts{};
};

} // namespace

std::set<std::string> fieldTexts()
{
    Collector all;
    all.collect(Scene{});
    all.collect(SphereMapDocument{});
    all.collect(LayerContent{});
    for (const LayerKind& kind : layerKinds()) {
        all.add(kind.title);
        all.add(kind.help);
    }
    for (const auto presets : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& preset : presets) {
            all.add(preset.title);
            all.add(preset.description);
        }
    for (const MaterialPreset& preset : materialPresets()) {
        all.add(preset.name);
        all.add(preset.description);
    }
    for (const Conductor& metal : conductors())
        all.add(metal.name);
    for (const PlannedStage& stage : makePlan({}, {Parameterization::Latlong, 512, 0}).decisions)
        all.add(stage.name);
    return std::move(all.texts);
}

} // namespace mirrorball::studio
