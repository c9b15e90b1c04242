#include "scene_file_page.h"

#include "core/base/field_checks.h"
#include "core/scene/scene_file.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace mirrorball::cli {

namespace {

constexpr const char* head = R"(# The scene file

`*.mirrorball`: JSON, UTF-8, with `"version": 1`. Every field may be left out and then has the default below; keys that this version does
not know are kept. Relative paths start at the file's folder. `--set FIELD=VALUE` sets any of them on the command line, with quotes around
words left out: `--set material.specular.exponent=200`, `--set view.background.color=[0,0,0]`. The studio writes such files, and so does
`render --save-scene`. `mirrorball reference FOLDER` makes this page from the program's own declarations.

```json ball.mirrorball
{
  "version": 1,
  "probe": {"source": "probe.hdr"},
  "material": {"specular": {"lobe": "phong", "exponent": 200}, "fresnel": {"kind": "dielectric", "index": 1.5}},
  "view": {"geometry": "torus", "width": 320, "height": 240},
  "exports": [{"name": "gloss", "kind": "specular", "parameterization": "cube", "size": 64}]
}
```

```
mirrorball render ball.mirrorball -o ball.png
mirrorball export ball.mirrorball -o maps
```
)";

/// Text as the cell of a table.
std::string cell(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '|')
            escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string rangeText(const FieldEntry& entry)
{
    std::string text;
    for (const std::string_view word : entry.words)
        text += (text.empty() ? "" : ", ") + std::string(word);
    if (!text.empty())
        return text;
    constexpr double unbounded = std::numeric_limits<double>::max();
    if (entry.field.low == -unbounded && entry.field.high == unbounded)
        return "";
    text = numberText(entry.field.low) + " to " + numberText(entry.field.high);
    return entry.field.unit.empty() ? text : text + " " + std::string(entry.field.unit);
}

/// A table a group: the fields "view.camera.yaw" and "view.camera.fov" stand below the heading "view.camera".
std::string tables(const std::vector<FieldEntry>& entries, const Scene& scene)
{
    std::vector<std::pair<std::string, std::string>> groups; // heading and rows, in the order of their first fields
    for (const FieldEntry& entry : entries) {
        const size_t dot = entry.path.rfind('.');
        const std::string heading = entry.path.substr(0, dot == std::string::npos ? 0 : dot);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.first == heading; });
        if (group == groups.end())
            group = groups.insert(groups.end(), {heading, ""});
        std::string initial = fieldText(scene, entry.path);
        initial.erase(std::remove_if(initial.begin(), initial.end(), [](char c) { return c == '\n' || c == ' '; }), initial.end());
        group->second += "| " + std::string(entry.field.name) + " | `" + cell(initial) + "` | " + cell(rangeText(entry)) + " | " +
                         cell(entry.field.help) + " |\n";
    }
    std::string text;
    for (const auto& [heading, rows] : groups)
        text += "\n## " + (heading == "exports[0]" ? "exports, a list of these" : heading) +
                "\n\n| field | default | may be | what |\n|---|---|---|---|\n" + rows;
    return text;
}

} // namespace

std::string sceneFilePage()
{
    Scene withExport;
    withExport.exports.emplace_back();
    return head + tables(sceneFields(), Scene{}) + tables(exportFields(), withExport);
}

} // namespace mirrorball::cli
