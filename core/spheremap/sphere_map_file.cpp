#include "sphere_map_file.h"

#include "layer_json.h"
#include "sphere_map_json.h"
#include "stroke_json.h"

namespace mirrorball {

using namespace field_json;

namespace {

constexpr std::string_view what = "sphere map"; // for messages

} // namespace

SphereMapDocument sphereMapFromJson(const Json& json)
{
    if (json.contains("strokes") && !json.contains("layers")) { // strokes by themselves
        SphereMapDocument painting;
        painting.layers = {{.name = "Paint", .content = PaintLayer{.strokes = strokesFromJson(json)}}};
        return painting;
    }
    SphereMapDocument document;
    Reader reader("", json);
    checkVersion(json, sphereMapFileVersion, what);
    reader.known().insert("version");
    SphereMapDocument::visitFields(document, reader);
    document.unknown = reader.unknownKeys();
    validate(document);
    return document;
}

OrderedJson sphereMapToJson(const SphereMapDocument& document)
{
    OrderedJson json;
    Writer writer(json);
    json["version"] = sphereMapFileVersion;
    SphereMapDocument::visitFields(document, writer);
    writer.writeUnknown(document.unknown);
    return json;
}

namespace {

void moveContent(LayerContent& content, const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::visit(
        [&](auto& layer) {
            if constexpr (requires { layer.source; })
                layer.source = rebased(layer.source, from, to);
        },
        content);
}

} // namespace

SphereMapDocument loadSphereMap(const std::filesystem::path& path)
{
    return namingFile(path, [&] {
        SphereMapDocument document = sphereMapFromJson(parse(readText(path, what), what));
        document.folder = folderOf(path);
        return document;
    });
}

void saveSphereMap(const SphereMapDocument& document, const std::filesystem::path& path)
{
    validate(document);
    save(sphereMapToJson(movedTo(document, folderOf(path))), path, what);
}

SphereMapDocument sphereMapFromText(const std::string& text) { return sphereMapFromJson(parse(text, what)); }

std::string sphereMapToText(const SphereMapDocument& document)
{
    validate(document);
    return sphereMapToJson(document).dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

SphereMapDocument movedTo(SphereMapDocument document, const std::filesystem::path& folder)
{
    const std::filesystem::path from = std::filesystem::absolute(document.folder.empty() ? "." : document.folder).lexically_normal();
    const std::filesystem::path to = std::filesystem::absolute(folder.empty() ? "." : folder).lexically_normal();
    if (from != to)
        for (Layer& layer : document.layers) {
            moveContent(layer.content, from, to);
            if (layer.mask)
                moveContent(layer.mask->content, from, to);
        }
    document.folder = folder;
    return document;
}

} // namespace mirrorball
