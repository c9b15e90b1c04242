#include "map_file.h"

#include "builtin_probes.h"
#include "layout_detection.h"

#include "../error.h"

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";
constexpr std::array<std::string_view, 6> faceNames{"px", "nx", "py", "ny", "pz", "nz"};

/// NAME.LEVEL.EXT
std::filesystem::path withLevel(const std::filesystem::path& path, size_t level)
{
    std::filesystem::path result = path;
    result.replace_extension();
    result += '.';
    result += std::to_string(level);
    result += path.extension();
    return result;
}

/// Whether each level has half the edges of the one before, rounded down, which a mip-mapped file takes for granted.
bool halveExactly(const std::vector<Image>& levels)
{
    for (size_t i = 1; i < levels.size(); ++i)
        if (levels[i].width != std::max(1, levels[i - 1].width / 2) || levels[i].height != std::max(1, levels[i - 1].height / 2))
            return false;
    return true;
}

std::vector<std::filesystem::path> writeLevels(const std::filesystem::path& out, const std::vector<Image>& levels, const WriteOptions& options)
{
    if (levels.size() == 1) {
        writeImage(out, levels.front(), options);
        return {out};
    }
    if (holdsMips(out) && halveExactly(levels)) {
        writeMips(out, levels, options);
        return {out};
    }
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < levels.size(); ++i) {
        files.push_back(withLevel(out, i));
        writeImage(files.back(), levels[i], options);
    }
    return files;
}

Image face(const Image& cube, int index)
{
    Image result(cube.width, cube.width, cube.channels);
    std::copy_n(cube.row(index * cube.width), result.texels.size(), result.texels.begin());
    return result;
}

} // namespace

Probe readProbe(const std::string& probe, const ReadProbeOptions& options, const JobControl& job, std::vector<Stage>& stages)
{
    Probe result;
    if (probe.starts_with(builtinPrefix)) {
        result.map = timedStage(stages, "compute probe",
                                [&] { return renderBuiltinProbe(probe.substr(builtinPrefix.size()), builtinProbeLayout, job); });
        result.origin = "built in";
        return result;
    }
    const Detection detection = detectLayout(openImage(probe)->info(), options.from);
    Image image = timedStage(stages, "read probe", [&] { return readImage(probe, job); });
    result.repaired = timedStage(stages, "repair", [&] { return repair(image, options.negatives); });
    stages.back().why = describe(result.repaired);
    result.origin = detection.reason;
    result.certain = detection.certain;
    result.map = toEnvironmentMap(std::move(image), detection, job);
    return result;
}

std::vector<std::filesystem::path> writeMap(const std::filesystem::path& out, const std::vector<EnvironmentMap>& levels,
                                            const WriteOptions& options)
{
    const MapLayout& layout = levels.front().layout;
    WriteOptions described = options;
    described.attributes["mirrorball:parameterization"] = name(layout.kind);
    if (layout.border > 0)
        described.attributes["mirrorball:border"] = std::to_string(layout.border);

    const std::string file = out.filename().string();
    const size_t mark = file.find("%s");
    std::vector<Image> images;
    if (mark == std::string::npos) {
        for (const EnvironmentMap& level : levels)
            images.push_back(level.image);
        return writeLevels(out, images, described);
    }
    if (layout.kind != Parameterization::Cube)
        throw InvalidArgument("output: '%s' stands for the six faces of a cube, but this map is a " + std::string(name(layout.kind)) + " map; give a plain name");
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < 6; ++i) {
        images.clear();
        for (const EnvironmentMap& level : levels)
            images.push_back(face(level.image, i));
        std::string faceFile = file;
        faceFile.replace(mark, 2, faceNames[static_cast<size_t>(i)]);
        described.attributes["mirrorball:parameterization"] = "cube face " + std::string(faceNames[static_cast<size_t>(i)]);
        for (auto& written : writeLevels(out.parent_path() / faceFile, images, described))
            files.push_back(std::move(written));
    }
    return files;
}

} // namespace mirrorball
