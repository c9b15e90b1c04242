#include "stroke_file.h"

#include "stroke_json.h"

namespace mirrorball {

using namespace field_json;

namespace {
constexpr std::string_view what = "list of strokes"; // for messages
} // namespace

std::vector<Stroke> strokesFromJson(const Json& json)
{
    checkVersion(json, strokeFileVersion, what);
    if (!json.contains("strokes"))
        throw InvalidArgument("strokes: are missing; a file of strokes is {\"version\": 1, \"strokes\": [...]}");
    std::vector<Stroke> strokes;
    Reader::read("strokes", Field{.name = "strokes", .help = "", .low = 0, .high = mostStrokes}, json["strokes"], strokes);
    validate(strokes);
    return strokes;
}

std::vector<Stroke> loadStrokes(const std::filesystem::path& path)
{
    return namingFile(path, [&] { return strokesFromJson(parse(readText(path, what), what)); });
}

void saveStrokes(std::span<const Stroke> strokes, const std::filesystem::path& path)
{
    validate(strokes);
    OrderedJson json;
    json["version"] = strokeFileVersion;
    OrderedJson& list = json["strokes"] = OrderedJson::array();
    for (const Stroke& stroke : strokes)
        list.push_back(writeJson(stroke));
    save(json, path, what);
}

} // namespace mirrorball
