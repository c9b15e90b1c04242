#include "variants.h"

#include "core/base/error.h"

namespace mirrorball::cli {

namespace {

/// The text cut at a separator, but for those inside of quotes and brackets.
std::vector<std::string> divided(const std::string& text, char separator)
{
    std::vector<std::string> parts{""};
    int depth = 0;
    bool isQuoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && (i == 0 || text[i - 1] != '\\'))
            isQuoted = !isQuoted;
        if (!isQuoted)
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (c == separator && depth <= 0 && !isQuoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

} // namespace

std::string GridAxis::label(size_t index) const
{
    const std::string name = field.substr(field.rfind('.') + 1); // all of it where there is no dot
    const std::string& value = values[index];
    return name + " " + (value.starts_with('[') ? value : value.substr(value.rfind('/') + 1));
}

GridAxis parseGridAxis(const std::string& text)
{
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw InvalidArgument("--grid: must be FIELD=VALUE,VALUE, such as material.specular.roughness=0,0.2,0.5; it is '" + text + "'");
    GridAxis axis{.field = text.substr(0, equals)};
    const std::string values = text.substr(equals + 1);
    axis.values = divided(values, ';');
    if (axis.values.size() == 1)
        axis.values = divided(values, ',');
    for (const std::string& value : axis.values)
        if (value.empty())
            throw InvalidArgument("--grid " + axis.field + ": a value is empty in '" + values +
                                  "'; write VALUE,VALUE, an empty text as \"\"");
    return axis;
}

std::vector<GridAxis> parseGrid(const std::vector<std::string>& texts)
{
    if (texts.size() > 2)
        throw InvalidArgument("--grid: given " + std::to_string(texts.size()) +
                              " times; the first makes the columns and the second the rows of one picture");
    std::vector<GridAxis> axes;
    for (const std::string& text : texts)
        axes.push_back(parseGridAxis(text));
    if (axes.size() == 2 && axes[0].field == axes[1].field)
        throw InvalidArgument("--grid: " + axes[0].field + " is given for columns and rows; name another field for one of them");
    size_t cells = 1;
    for (const GridAxis& axis : axes)
        cells *= axis.values.size();
    if (cells > static_cast<size_t>(mostCells))
        throw InvalidArgument("--grid: " + std::to_string(cells) + " cells; one picture has at most " + std::to_string(mostCells) +
                              ", so give fewer values");
    return axes;
}

Scene turned(Scene scene, Turns turns, int frame, int count)
{
    constexpr double farthest = 36000.0; // of both fields: whole turns, so that taking them away changes nothing
    double& yaw = turns == Turns::Camera ? scene.view.camera.yawDeg : scene.probe.yawDeg;
    yaw += 360.0 * (frame - 1) / count;
    if (yaw > farthest)
        yaw -= farthest;
    return scene;
}

} // namespace mirrorball::cli
