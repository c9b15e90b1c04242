#include "sphere_map_file.h"

#include "core/spheremap/strokes/stroke_json.h"
#include "layer_json.h"
#include "sphere_map_json.h"

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

using ChangePath = std::string (*)(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

void changePath(LayerContent& content, ChangePath change, const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::visit(
        [&](auto& layer) {
            if constexpr (requires { std::string_view(layer.source); })
                layer.source = change(layer.source, from, to);
        },
        content);
}

SphereMapDocument withPathsFrom(SphereMapDocument document, const std::filesystem::path& folder, ChangePath change)
{
    const auto whole = [](const std::filesystem::path& path) {
        return std::filesystem::absolute(path.empty() ? "." : path).lexically_normal();
    };
    const std::filesystem::path from = whole(document.folder), to = whole(folder);
    for (Layer& layer : document.layers) {
        changePath(layer.content, change, from, to);
        if (layer.mask)
            changePath(layer.mask->content, change, from, to);
    }
    document.folder = folder;
    return document;
}

} // namespace

SphereMapDocument loadSphereMap(const std::filesystem::path& path)
{
    return namingFile(path, [&] {
        SphereMapDocument document = sphereMapFromJson(parse(readText(path, what), what));
        document.folder = folderOf(path);
        return withPathsFrom(std::move(document), folderOf(path),
                             [](const std::string& file, const auto& folder, const auto&) { return withSlashes(file, folder); });
    });
}

void saveSphereMap(const SphereMapDocument& document, const std::filesystem::path& path)
{
    validate(document);
    save(sphereMapToJson(storedIn(document, folderOf(path))), path, what);
}

SphereMapDocument sphereMapFromText(const std::string& text) { return sphereMapFromJson(parse(text, what)); }

std::string sphereMapToText(const SphereMapDocument& document)
{
    validate(document);
    return sphereMapToJson(document).dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

SphereMapDocument movedTo(SphereMapDocument document, const std::filesystem::path& folder)
{
    return withPathsFrom(std::move(document), folder, rebased);
}

SphereMapDocument storedIn(SphereMapDocument document, const std::filesystem::path& folder)
{
    return withPathsFrom(std::move(document), folder, storedPath);
}

} // namespace mirrorball
