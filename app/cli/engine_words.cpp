#include "engine_words.h"

#include "core/base/error.h"

namespace mirrorball::cli {

EngineTurn engineTurn(const std::string& engine, Parameterization kind)
{
    if (engine.empty())
        return {};
    const EngineProfile& profile = engineProfile(engine);
    const std::string title(profile.title);
    if (kind == Parameterization::Cube && profile.law)
        return {.orientation = profile.cube};
    if (kind == Parameterization::Latlong && profile.takesLatlong)
        return {.yawDeg = profile.latlongYawDeg};
    throw InvalidArgument("--for: " + title + " takes no " + std::string(name(kind)) + " map; use --to " +
                          (profile.takesLatlong ? "latlong" : "cube") + ", or mirrorball export --for " + engine);
}

void store(std::vector<EnvironmentMap>& levels, const CubeOrientation& orientation)
{
    if (orientation == CubeOrientation{})
        return;
    for (EnvironmentMap& level : levels)
        if (level.layout.kind == Parameterization::Cube)
            level.image = toStored(level.image, orientation);
}

ByteEncoding parseEncode(const std::string& word, const std::filesystem::path& out)
{
    if (word.empty())
        return ByteEncoding::Filmic;
    const auto known = words(ByteEncoding{});
    for (size_t i = 0; i < known.size(); ++i)
        if (known[i] == word) {
            const auto bytes = static_cast<ByteEncoding>(i);
            checkBytes(out, bytes);
            return bytes;
        }
    throw InvalidArgument("--encode: '" + word + "' is none; choose srgb, filmic, rgbe, rgbm, rgbd or rgbp");
}

} // namespace mirrorball::cli
