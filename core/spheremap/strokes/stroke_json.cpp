#include "stroke_json.h"

#include <algorithm>
#include <charconv>

namespace mirrorball {

using namespace field_json;

namespace {

/// Reads one point off the front of a text; what is left begins at the comma after it.
StrokePoint takePoint(std::string_view& text, const std::string& path, size_t index)
{
    double numbers[5] = {0.0, 0.0, 1.0, 0.0, 0.0};
    int count = 0;
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \n\r\t"), text.size()));
        if (text.empty() || text.front() == ',')
            break;
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const auto used = static_cast<size_t>(end - text.data());
        const bool ends = used == text.size() || std::string_view(" \n\r\t,").find(text[used]) != std::string_view::npos;
        if (error != std::errc() || !ends || count == 5)
            throw InvalidArgument(path + "[" + std::to_string(index) + "]: must be \"x y pressure\", points apart by commas; it goes on " +
                                  inQuotes(text.substr(0, 20)));
        numbers[count++] = value;
        text.remove_prefix(used);
    }
    if (count < 2)
        throw InvalidArgument(path + "[" + std::to_string(index) + "]: must be \"x y pressure\"; a number is missing");
    if (count == 4)
        throw InvalidArgument(path + "[" + std::to_string(index) + "]: must be \"x y pressure tilt-x tilt-y\"; the second tilt is missing");
    return {{numbers[0], numbers[1]}, numbers[2], {numbers[3], numbers[4]}};
}

std::vector<StrokePoint> pointsFromText(const std::string& path, std::string_view text)
{
    std::vector<StrokePoint> points;
    while (text.find_first_not_of(" \n\r\t") != std::string_view::npos) {
        if (points.size() == mostStrokePoints)
            throw InvalidArgument(path + ": are more than " + std::to_string(mostStrokePoints) + "; thin the stroke out");
        points.push_back(takePoint(text, path, points.size()));
        if (!text.empty())
            text.remove_prefix(1); // the comma
    }
    return points;
}

std::vector<StrokePoint> pointsFromList(const std::string& path, const Json& list)
{
    if (list.size() > mostStrokePoints)
        throw InvalidArgument(path + ": are more than " + std::to_string(mostStrokePoints) + "; thin the stroke out");
    std::vector<StrokePoint> points;
    points.reserve(list.size());
    for (const Json& entry : list) {
        const size_t count = entry.size();
        const bool numbers = entry.is_array() && (count == 2 || count == 3 || count == 5) &&
                             std::all_of(entry.begin(), entry.end(), [](const Json& number) { return number.is_number(); });
        if (!numbers)
            refuse(path + "[" + std::to_string(points.size()) + "]", "a list [x, y, pressure] or [x, y, pressure, tilt-x, tilt-y]", entry);
        const auto number = [&](size_t i, double missing) { return i < count ? entry[i].get<double>() : missing; };
        points.push_back({{number(0, 0.0), number(1, 0.0)}, number(2, 1.0), {number(3, 0.0), number(4, 0.0)}});
    }
    return points;
}

std::string pointsToText(const std::vector<StrokePoint>& points)
{
    std::string text;
    char digits[32];
    const auto add = [&](double value, char after) {
        text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
        text += after;
    };
    for (const StrokePoint& point : points) {
        add(point.q.x, ' ');
        add(point.q.y, ' ');
        if (point.tilt == glm::dvec2(0.0)) {
            add(point.pressure, ',');
            continue;
        }
        add(point.pressure, ' ');
        add(point.tilt.x, ' ');
        add(point.tilt.y, ',');
    }
    if (!text.empty())
        text.pop_back();
    return text;
}

/// The members in which a struct differs from a fresh one, which is what reading fills in for missing ones: strokes are many.
template <typename T>
OrderedJson changedMembers(const T& value)
{
    static const OrderedJson fresh = Writer::toJson(T{});
    const OrderedJson all = Writer::toJson(value);
    OrderedJson changed = OrderedJson::object();
    auto& members = changed.get_ref<OrderedJson::object_t&>();
    for (const auto& [name, member] : all.get_ref<const OrderedJson::object_t&>())
        if (const auto same = fresh.find(name); same == fresh.end() || *same != member)
            members.push_back({name, member});
    return changed;
}

} // namespace

void readJson(const std::string& path, const nlohmann::json& json, Stroke& stroke)
{
    Reader reader(path, json);
    reader(Field{.name = "brush", .help = ""}, stroke.brush);
    reader(Field{.name = "symmetry", .help = ""}, stroke.symmetry);
    reader.known().insert("points");
    const auto points = json.find("points");
    if (points == json.end())
        throw InvalidArgument(path + ".points: are missing; write \"points\": \"x y pressure, ...\"");
    if (points->is_string())
        stroke.points = pointsFromText(path + ".points", points->get_ref<const std::string&>());
    else if (points->is_array())
        stroke.points = pointsFromList(path + ".points", *points);
    else
        refuse(path + ".points", "a text \"x y pressure, ...\" or a list of lists", *points);
    stroke.unknown = reader.unknownKeys();
    checkFields(path, stroke);
}

nlohmann::ordered_json writeJson(const Stroke& stroke)
{
    OrderedJson json;
    Writer writer(json);
    if (OrderedJson brush = changedMembers(stroke.brush); !brush.empty())
        json["brush"] = std::move(brush);
    if (OrderedJson symmetry = changedMembers(stroke.symmetry); !symmetry.empty())
        json["symmetry"] = std::move(symmetry);
    json["points"] = pointsToText(stroke.points);
    writer.writeUnknown(stroke.unknown);
    return json;
}

} // namespace mirrorball
