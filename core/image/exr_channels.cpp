#include "exr_channels.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <ImfHeader.h>
#include <ImfPartType.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

namespace mirrorball::exr {
namespace {

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// What a picture's channels are, best first.
enum class Content { Color, Luminance, Lone, Other };

/// How likely a name is that of the light one sees, best first.
enum class NameRank { Plain, Beauty, Unknown, Auxiliary };

struct Candidate {
    Picture picture;
    Content content;
    NameRank rank;
    bool right; ///< the right eye of a stereo pair
    auto order() const { return std::tuple(content, rank, right); }
};

/// A layer's channels: the last words of their names, in lower case, and the names.
using LayerChannels = std::vector<std::pair<std::string, std::string>>;

/// The channel of a layer that goes by one of two names, in upper or lower case.
std::string findChannel(const LayerChannels& channels, std::string_view letter, std::string_view word)
{
    for (const auto& [last, name] : channels)
        if (last == letter || last == word)
            return name;
    return {};
}

/// The layers of a part without their dot: the unnamed one first, then by name.
std::map<std::string, LayerChannels> layersOf(const Imf::ChannelList& channels)
{
    std::map<std::string, LayerChannels> layers;
    for (auto i = channels.begin(); i != channels.end(); ++i) {
        const std::string name = i.name();
        const size_t dot = name.rfind('.');
        const bool named = dot != std::string::npos;
        layers[named ? name.substr(0, dot) : ""].emplace_back(lowerCase(named ? name.substr(dot + 1) : name), name);
    }
    return layers;
}

bool isFlat(const Imf::Header& header)
{
    const std::string type = header.hasType() ? header.type() : Imf::SCANLINEIMAGE;
    return type == Imf::SCANLINEIMAGE || type == Imf::TILEDIMAGE;
}

std::vector<std::string> wordsOf(const std::string& name)
{
    std::vector<std::string> found{""};
    for (const char c : lowerCase(name))
        if (std::isalpha(static_cast<unsigned char>(c)))
            found.back() += c;
        else if (!found.back().empty())
            found.emplace_back();
    std::erase(found, std::string());
    return found;
}

/// The last word that says something decides: "ViewLayer.Combined" is a beauty, "beauty_albedo" is none.
NameRank rankOf(const std::vector<std::string>& names)
{
    static const std::set<std::string, std::less<>> beauty{"combined", "beauty",  "rgba",  "rgb", "color",   "color",
                                                           "main",     "default", "final", "c",   "compose", "composite"};
    static const std::set<std::string, std::less<>> auxiliary{
        "albedo",   "normal",      "normals",    "n",        "nx",         "depth",   "z",          "zdepth",       "position",
        "p",        "pos",         "pworld",     "point",    "diffuse",    "diff",    "diffcol",    "diffdir",      "diffind",
        "specular", "spec",        "glossy",     "glosscol", "emission",   "emit",    "emissive",   "shadow",       "shadows",
        "ao",       "occlusion",   "uv",         "st",       "motion",     "vector",  "velocity",   "mask",         "matte",
        "variance", "denoise",     "denoising",  "noisy",    "reflection", "reflect", "refraction", "transmission", "transdir",
        "transcol", "sss",         "subsurface", "direct",   "indirect",   "gi",      "id",         "object",       "objectid",
        "material", "alpha",       "a",          "coat",     "sheen",      "volume",  "mist",       "index",        "indexob",
        "crypto",   "cryptomatte", "heat",       "samples",  "count",      "tangent", "derivative", "roughness",    "metallic",
        "lighting", "background",  "env"};
    NameRank rank = names.empty() ? NameRank::Plain : NameRank::Unknown;
    for (const std::string& word : names) {
        if (beauty.contains(word))
            rank = NameRank::Beauty;
        else if (auxiliary.contains(word) || word.starts_with("crypto") || word.starts_with("denois"))
            rank = NameRank::Auxiliary;
    }
    return rank;
}

/// The colors that a layer has by the names of its channels.
std::optional<std::pair<ColorChannels, Content>> colorsOf(const LayerChannels& channels)
{
    const auto find = [&](std::string_view letter, std::string_view word) { return findChannel(channels, letter, word); };
    const ColorChannels color{{find("r", "red"), find("g", "green"), find("b", "blue")}, find("a", "alpha")};
    if (std::count(color.rgb.begin(), color.rgb.end(), std::string()) <= 1)
        return std::pair(color, Content::Color);
    const std::string y = find("y", "luminance");
    const bool isVector = !find("x", "x").empty() || !find("z", "z").empty();
    if (!y.empty() && !isVector)
        return std::pair(ColorChannels{{y, y, y}, color.alpha, find("ry", "ry") == "RY" && find("by", "by") == "BY"}, Content::Luminance);
    return std::nullopt;
}

/// A single channel, or X, Y and Z: colors only where somebody asks for them.
std::optional<std::pair<ColorChannels, Content>> anyOf(const LayerChannels& channels)
{
    const ColorChannels vector{{findChannel(channels, "x", "x"), findChannel(channels, "y", "y"), findChannel(channels, "z", "z")}};
    if (std::count(vector.rgb.begin(), vector.rgb.end(), std::string()) <= 1)
        return std::pair(vector, Content::Other);
    if (channels.size() != 1)
        return std::nullopt;
    const auto& [last, name] = channels.front();
    const bool isColor = rankOf(wordsOf(last)) != NameRank::Auxiliary && last != "x";
    return std::pair(ColorChannels{{name, name, name}}, isColor ? Content::Lone : Content::Other);
}

std::vector<Candidate> candidates(const Imf::MultiPartInputFile& file)
{
    std::vector<Candidate> found;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        if (!isFlat(header))
            continue;
        const std::string partName = header.hasName() ? header.name() : std::string();
        for (const auto& [layer, channels] : layersOf(header.channels())) {
            auto colors = colorsOf(channels);
            if (!colors)
                colors = anyOf(channels);
            if (!colors)
                continue;
            const std::vector<std::string> names = wordsOf(partName + "." + layer);
            found.push_back({{part, partName, layer, colors->first},
                             colors->second,
                             rankOf(names),
                             std::find(names.begin(), names.end(), "right") != names.end()});
        }
    }
    return found;
}

/// Whether the last words of a dotted name are `words`, whatever the case.
bool endsIn(const std::string& name, const std::string& words)
{
    const std::string a = lowerCase(name), b = lowerCase(words);
    return a == b || a.ends_with("." + b);
}

std::string partText(const Picture& picture)
{
    return std::to_string(picture.part) + (picture.partName.empty() ? "" : " (" + oneLine(picture.partName) + ")");
}

std::string layerText(const Picture& picture) { return picture.layer.empty() ? "default" : oneLine(picture.layer); }

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (size_t i = 0; i < names.size() && i < 30; ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > 30 ? text + ", ..." : text;
}

/// What one could choose, each once.
template <typename Text>
std::vector<std::string> texts(const std::vector<Candidate>& from, const Text& text)
{
    std::vector<std::string> found;
    for (const Candidate& c : from)
        if (std::find(found.begin(), found.end(), text(c.picture)) == found.end())
            found.push_back(text(c.picture));
    return found;
}

void keepPart(const std::string& path, const Imf::MultiPartInputFile& file, const std::string& wanted, std::vector<Candidate>& from)
{
    const bool isNumber = std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); }) && wanted.size() < 7;
    const std::vector<std::string> known = texts(from, partText);
    std::erase_if(from,
                  [&](const Candidate& c) { return isNumber ? c.picture.part != std::stoi(wanted) : !endsIn(c.picture.partName, wanted); });
    if (from.empty())
        throw FileError(path, "it has no flat part '" + oneLine(wanted) + "' with colors among its " + std::to_string(file.parts()) +
                                  "; choose " + listed(known) + " by number or name");
}

void keepLayer(const std::string& path, const Imf::MultiPartInputFile& file, const std::string& wanted, std::vector<Candidate>& from)
{
    std::vector<Candidate> kept;
    std::vector<std::string> known = texts(from, layerText);
    const auto keep = [&](auto&& isIt) { std::copy_if(from.begin(), from.end(), std::back_inserter(kept), isIt); };
    if (wanted == "default")
        keep([&](const Candidate& c) { return c.picture.layer.empty(); });
    if (kept.empty())
        keep([&](const Candidate& c) { return !c.picture.layer.empty() && endsIn(c.picture.layer, wanted); });
    if (kept.empty()) // in files of many parts, a layer is a part
        keep([&](const Candidate& c) { return c.picture.layer.empty() && endsIn(c.picture.partName, wanted); });
    if (kept.empty()) // a single channel
        for (int part = 0; part < file.parts(); ++part)
            if (isFlat(file.header(part)) && file.header(part).channels().findChannel(wanted))
                kept.push_back({{part, file.header(part).hasName() ? file.header(part).name() : "", wanted, {{wanted, wanted, wanted}}},
                                Content::Lone,
                                NameRank::Plain,
                                false});
    if (kept.empty())
        throw FileError(path, "it has no layer '" + oneLine(wanted) + "'; choose " + listed(known));
    from = std::move(kept);
}

/// Why there is nothing to read.
FileError noColors(const std::string& path, const Imf::MultiPartInputFile& file, const std::vector<Candidate>& others)
{
    const auto isDeep = [&](int part) { return file.header(part).hasType() && Imf::isDeepData(file.header(part).type()); };
    for (int part = 0; part < file.parts(); ++part)
        if (isDeep(part) && others.empty())
            return FileError(path, "it holds only deep images, which have no single color per texel; flatten it first");
    return FileError(path, "none of its channels is R, G, B or Y" +
                               (others.empty() ? std::string("; export it with color channels")
                                               : ", only what is no light (" + listed(texts(others, layerText)) +
                                                     "); export it with color channels, or ask for one with --layer"));
}

Assumption assumption(const char* topic, std::string value, const std::vector<std::string>& all, bool asked, Certainty certainty)
{
    std::vector<std::string> others = all;
    std::erase(others, value);
    const char* why = asked                           ? "asked for"
                      : all.size() == 1               ? "the only one"
                      : certainty == Certainty::Guess ? "the first with colors"
                                                      : "by its channels and name";
    return {topic, std::move(value), why, asked ? Certainty::Certain : certainty, std::move(others)};
}

} // namespace

ChosenPicture choosePicture(const std::string& path, const Imf::MultiPartInputFile& file, const ProbeReading& reading)
{
    const std::vector<Candidate> all = candidates(file);
    std::vector<Candidate> left = all;
    const bool asked = !reading.part.empty() || !reading.layer.empty();
    if (!reading.part.empty())
        keepPart(path, file, reading.part, left);
    if (!reading.layer.empty())
        keepLayer(path, file, reading.layer, left);
    if (!asked)
        std::erase_if(left, [](const Candidate& c) { return c.content == Content::Other; });
    if (left.empty())
        throw noColors(path, file, all);
    const auto better = [](const Candidate& a, const Candidate& b) { return a.order() < b.order(); };
    const auto best = std::min_element(left.begin(), left.end(), better);
    // The right eye, a lone channel or an auxiliary pass beside the chosen one leaves no doubt; another picture of the same standing does.
    const auto alike = std::count_if(left.begin(), left.end(), [&](const Candidate& c) { return c.order() == best->order(); });
    const bool plain = best->content == Content::Color && best->rank != NameRank::Unknown && best->rank != NameRank::Auxiliary;
    const Certainty certainty = left.size() == 1 ? Certainty::Certain
                                : alike > 1      ? Certainty::Guess
                                : plain          ? Certainty::Certain
                                                 : Certainty::Likely;

    ChosenPicture chosen{best->picture};
    chosen.assumed.push_back(assumption("part", partText(best->picture), texts(all, partText), !reading.part.empty(), certainty));
    std::vector<Candidate> beside = all;
    std::erase_if(beside, [&](const Candidate& c) { return c.picture.part != best->picture.part; });
    chosen.assumed.push_back(assumption("layer", layerText(best->picture), texts(beside, layerText), !reading.layer.empty(), certainty));
    return chosen;
}

std::optional<Picture> findPass(const Imf::MultiPartInputFile& file, const std::string& pass)
{
    for (const Candidate& c : candidates(file))
        if (c.content == Content::Color && std::count(c.picture.channels.rgb.begin(), c.picture.channels.rgb.end(), std::string()) == 0 &&
            endsIn(c.picture.layer.empty() ? c.picture.partName : c.picture.layer, pass))
            return c.picture;
    return std::nullopt;
}

} // namespace mirrorball::exr
