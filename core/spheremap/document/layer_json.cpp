#include "layer_json.h"

#include "core/spheremap/strokes/stroke_json.h"

namespace mirrorball {

using namespace field_json;

void readJson(const std::string& path, const Json& json, LayerContent& content)
{
    if (!json.is_object())
        refuse(path, "an object in { }", json);
    const auto kind = json.find("kind");
    if (kind == json.end())
        throw InvalidArgument(path + ".kind: is missing; name one, such as \"gradient\"");
    if (!kind->is_string() || kind->get_ref<const std::string&>().empty())
        refuse(path + ".kind", "the name of a kind, such as \"gradient\"", *kind);
    content = makeContent(kind->get_ref<const std::string&>());
    std::visit(
        [&](auto& layer) {
            using Kind = std::decay_t<decltype(layer)>;
            if constexpr (hasFields<Kind>) {
                Reader reader(path, json);
                reader.known().insert("kind");
                Kind::visitFields(layer, reader);
                layer.unknown = reader.unknownKeys();
            } else {
                layer.text = json.dump();
            }
        },
        content);
}

OrderedJson writeJson(const LayerContent& content)
{
    return std::visit(
        [](const auto& layer) {
            using Kind = std::decay_t<decltype(layer)>;
            if constexpr (hasFields<Kind>) {
                OrderedJson json;
                Writer writer(json);
                json["kind"] = Kind::kind.name;
                Kind::visitFields(layer, writer);
                writer.writeUnknown(layer.unknown);
                return json;
            } else {
                OrderedJson json = OrderedJson::parse(layer.text);
                json["kind"] = layer.name;
                return json;
            }
        },
        content);
}

} // namespace mirrorball
