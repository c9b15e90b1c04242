#include "engine_export.h"

#include "engine_snippets.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/image/container/dds.h"
#include "core/image/container/ktx1.h"
#include "core/image/container/ktx2.h"
#include "core/image/container/play_canvas_atlas.h"
#include "core/image/map_file.h"
#include "core/image/reproject.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace mirrorball {

namespace {

void checkName(const std::string& name)
{
    const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
    if (name.empty() || name.size() > 100 || name.front() == '-' || !std::all_of(name.begin(), name.end(), allowed))
        throw InvalidArgument("name: '" + shownPath(name) + "' must be letters, digits, - and _; it names the files");
}

std::string fileName(const EngineFile& file, const std::string& name)
{
    std::string text(file.file);
    const std::string_view mark = "{name}";
    if (const size_t at = text.find(mark); at != std::string::npos)
        text.replace(at, mark.size(), name);
    return text;
}

bool isCube(EngineContent content)
{
    return content == EngineContent::SpecularCube || content == EngineContent::DiffuseCube || content == EngineContent::Skybox ||
           content == EngineContent::BabylonEnv;
}

std::int64_t cubeTexels(int size, int levels)
{
    std::int64_t texels = 0;
    for (int level = 0; level < levels; ++level)
        texels += 6LL * std::max(1, size >> level) * std::max(1, size >> level);
    return texels;
}

/// Everything that files of one export share, made when first asked for.
class Light {
public:
    Light(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options, int size, const JobControl& job,
          std::vector<Stage>& stages)
        : m_probe(probe), m_profile(profile), m_options(options), m_size(size), m_job(job), m_stages(stages)
    {
    }

    /// The chain in our convention; its level 0 is the skybox of the same size too.
    const std::vector<EnvironmentMap>& chain()
    {
        if (m_chain.empty())
            m_chain = timedStage(m_stages, "filter levels", [&] {
                return lawChain(m_probe, *m_profile.law, m_size, chainLevels(m_profile, m_size), m_options, m_job);
            });
        return m_chain;
    }
    EnvironmentMap skybox()
    {
        if (!m_chain.empty())
            return m_chain.front();
        return timedStage(m_stages, "resample skybox", [&] {
            return reproject(*m_probe.latlong(), {.target = {Parameterization::Cube, m_size, 0}, .yaw = m_options.yaw}, m_job);
        });
    }
    EnvironmentMap diffuse(const MapLayout& target)
    {
        return timedStage(m_stages, "filter diffuse", [&] {
            return prefilter(m_probe, {.lobe = diffuseLobe(), .target = target, .tolerance = m_options.tolerance, .yaw = m_options.yaw},
                             m_job)
                .map;
        });
    }
    EnvironmentMap latlong(int height)
    {
        const double yaw = m_options.yaw + m_profile.latlongYawDeg * std::numbers::pi / 180.0;
        return timedStage(m_stages, "turn latlong", [&] {
            return reproject(*m_probe.latlong(), {.target = {Parameterization::Latlong, height, 0}, .yaw = yaw}, m_job);
        });
    }
    const RadianceSh& sh()
    {
        if (!m_sh) {
            const EnvironmentMap exact = diffuse({Parameterization::Latlong, 32, 0}); // whose spectrum serves the nine as well
            timedStage(m_stages, "spherical harmonics", [&] {
                const RadianceSh nine = turned(radianceSh(m_probe.spectrum(2, m_job)), m_options.yaw);
                m_sh = nonNegative(nine);
                const glm::dvec3 least = leastIrradianceOverPi(nine);
                double lowest = 0.0;
                for (int c = 0; c < 3; ++c)
                    if (const double mean = nine.coefficients[0][c] * shNorm(0); mean > 0.0)
                        lowest = std::min(lowest, least[c] / mean);
                quality = ShQuality{shError(*m_sh, exact), shError(nine, exact), lowest};
            });
        }
        return *m_sh;
    }

    FilterSource& probe() { return m_probe; }
    const EngineProfile& profile() const { return m_profile; }
    const EngineExportOptions& options() const { return m_options; }
    const JobControl& job() const { return m_job; }
    std::vector<Stage>& stages() { return m_stages; }

    std::optional<ShQuality> quality{}; ///< once sh() was asked

private:
    FilterSource& m_probe;
    const EngineProfile& m_profile;
    const EngineExportOptions& m_options;
    int m_size;
    const JobControl& m_job;
    std::vector<Stage>& m_stages;
    std::vector<EnvironmentMap> m_chain{};
    std::optional<RadianceSh> m_sh{};
};

std::string containerBytes(const std::string& file, const Texture& texture, const EngineExportOptions& options)
{
    if (file.ends_with(".ktx2"))
        return ktx2::write(texture, options.compressKtx2 ? ktx2::Compression::Zstandard : ktx2::Compression::None);
    if (file.ends_with(".dds"))
        return dds::write(texture);
    return ktx1::write(texture, ktx1::SmallFloatType::Filament);
}

std::string babylonBytes(Light& light)
{
    babylon_env::Environment environment;
    const CubeOrientation stored{.axes = light.profile().cube.axes, .bottomUp = true};
    for (const EnvironmentMap& level : light.chain())
        environment.levels.push_back(toStored(level.image, stored));
    environment.irradiance = babylonPolynomial(light.sh());
    return timedStage(light.stages(), "encode faces", [&] { return babylon_env::write(environment, light.job()); });
}

std::string cubeBytes(const EngineFile& file, const std::string& named, Light& light)
{
    std::vector<EnvironmentMap> levels;
    switch (file.content) {
    case EngineContent::DiffuseCube:
        levels.push_back(light.diffuse({Parameterization::Cube, file.size, 0}));
        break;
    case EngineContent::Skybox:
        levels.push_back(light.skybox());
        break;
    default:
        levels = light.chain();
        break;
    }
    Texture texture = storedTexture(levels, light.profile().cube, light.options().texels.value_or(file.texels));
    if (light.profile().word == "filament" && file.content == EngineContent::SpecularCube)
        texture.metadata["sh"] = filamentMetadata(light.sh());
    return containerBytes(named, texture, light.options());
}

/// The bytes of every file but a latlong.
std::string fileBytes(const EngineFile& file, const std::string& named, Light& light)
{
    switch (file.content) {
    case EngineContent::BabylonEnv:
        return babylonBytes(light);
    case EngineContent::Atlas:
        return timedStage(light.stages(), "atlas", [&] {
            return play_canvas_atlas::write(playCanvasAtlas(light.probe(), light.options(), light.job()), light.options().atlas);
        });
    case EngineContent::Sh: {
        const RadianceSh& sh = light.sh();
        return named.ends_with(".json") ? shJson(sh, *light.quality) : filamentText(sh);
    }
    case EngineContent::Text:
        return engineSnippet(light.profile().word, light.options().name);
    default:
        return cubeBytes(file, named, light);
    }
}

void writeBytes(const std::filesystem::path& path, const std::string& bytes)
{
    AtomicFile file(path);
    file.write(bytes.data(), bytes.size());
    file.commit();
}

void makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw WorkError(folder.string() + ": cannot be made a folder" + (error ? ": " + error.message() : "") + "; choose another one");
}

std::string description(const EngineProfile& profile, const EngineExportOptions& options, const std::vector<EngineFilePlan>& files,
                        const EngineExport& done)
{
    nlohmann::ordered_json json{{"engine", profile.word}, {"title", profile.title}};
    if (profile.proven.empty())
        json["proven"] = nullptr;
    else
        json["proven"] = "in " + std::string(profile.proven);
    if (profile.law)
        json["roughness_law"] = name(*profile.law);
    json["latlong_yaw"] = profile.latlongYawDeg;
    if (!options.reading.empty())
        json["probe"] = nlohmann::ordered_json::parse(options.reading);
    for (const EngineFilePlan& file : files) {
        nlohmann::ordered_json row{{"file", file.file}, {"content", name(file.content)}};
        if (file.size > 0)
            row.update({{"size", file.size}, {"levels", file.levels}});
        if (!file.roughness.empty())
            row["roughness"] = file.roughness;
        json["files"].push_back(std::move(row));
    }
    if (done.sh)
        json["sh_rel_rms"] = done.sh->error;
    json["warnings"] = done.warnings;
    if (!profile.note.empty())
        json["note"] = profile.note;
    return json.dump(2) + "\n";
}

} // namespace

std::vector<EnvironmentMap> lawChain(FilterSource& probe, RoughnessLaw law, int size, int levels, const EngineExportOptions& options,
                                     const JobControl& job)
{
    std::vector<EnvironmentMap> chain;
    for (int level = 0; level < levels; ++level) {
        const double roughness = levelRoughness(law, level, levels, size);
        const auto share = [&](int l) { return static_cast<float>(l) / static_cast<float>(levels); };
        chain.push_back(prefilter(probe,
                                  {.lobe = ggxLobe(roughness * roughness),
                                   .target = {Parameterization::Cube, std::max(1, size >> level), 0},
                                   .tolerance = options.tolerance,
                                   .yaw = options.yaw},
                                  partOf(job, share(level), share(level + 1)))
                            .map);
    }
    return chain;
}

Texture storedTexture(const std::vector<EnvironmentMap>& levels, const CubeOrientation& orientation, TexelFormat format)
{
    Texture texture;
    texture.format = format;
    for (const EnvironmentMap& level : levels)
        texture.levels.push_back(toStored(level.image, orientation));
    return texture;
}

Image playCanvasAtlas(FilterSource& probe, const EngineExportOptions& options, const JobControl& job)
{
    using namespace play_canvas_atlas;
    Image atlas(size, size, 3);
    for (const Rectangle& r : rectangles) {
        // Read off a map of twice the rectangle's size: sharp parts by four lookups a texel, filtered ones, which are smooth, by one.
        const bool sharp = r.content == Content::Source;
        const MapLayout target{Parameterization::Latlong, std::max(2 * r.height, 64), 0};
        const Lobe lobe = r.content == Content::Diffuse ? diffuseLobe() : ggxLobe(r.roughness * r.roughness);
        const EnvironmentMap map =
            sharp ? reproject(*probe.latlong(), {.target = target, .yaw = options.yaw}, job)
                  : prefilter(probe, {.lobe = lobe, .target = target, .tolerance = options.tolerance, .yaw = options.yaw}, job).map;
        const std::vector<double> offsets = sharp ? std::vector{-0.25, 0.25} : std::vector{0.0};
        parallelRows(r.height, job, [&](int first, int last) {
            for (int j = first; j < last; ++j)
                for (int i = 0; i < r.width; ++i) {
                    glm::vec3 sum(0.0f);
                    for (const double dj : offsets)
                        for (const double di : offsets)
                            sum += map.radiance(direction(r, i + di, std::clamp(j, 1, r.height - 2) + dj));
                    sum /= static_cast<float>(offsets.size() * offsets.size());
                    std::copy_n(&sum.x, 3, atlas.texel(r.x + i, r.y + j));
                }
        });
    }
    return atlas;
}

std::vector<EngineFilePlan> planEngineExport(const EngineProfile& profile, const EngineExportOptions& options, const MapLayout& probe)
{
    checkName(options.name);
    const int size = checkedSize(profile, options.size);
    const int height = profile.law || size == 0 ? std::min(latlongHeight(probe), 8192) : size;
    std::vector<EngineFilePlan> plan;
    for (const EngineFile& file : profile.files) {
        EngineFilePlan row{.file = fileName(file, options.name), .content = file.content};
        if (isCube(file.content)) {
            row.size = file.size > 0 ? file.size : size;
            const bool chain = file.content == EngineContent::SpecularCube || file.content == EngineContent::BabylonEnv;
            row.levels = chain ? chainLevels(profile, row.size) : 1;
            for (int level = 0; chain && level < row.levels; ++level)
                row.roughness.push_back(levelRoughness(*profile.law, level, row.levels, row.size));
            const bool png = file.content == EngineContent::BabylonEnv; // which saves about a third of smooth levels
            row.bytes = cubeTexels(row.size, row.levels) * (png ? 3 : traits(options.texels.value_or(file.texels)).bytes) + 300;
        } else if (file.content == EngineContent::Latlong) {
            row.size = height;
            row.levels = 1;
            row.bytes = 2LL * height * height * (row.file.ends_with(".exr") ? 11 : 3);
        } else if (file.content == EngineContent::Atlas) {
            row.size = play_canvas_atlas::size;
            row.levels = 1;
            row.bytes = 3LL * play_canvas_atlas::size * play_canvas_atlas::size / 2;
        } else {
            row.bytes = 1500;
        }
        plan.push_back(std::move(row));
    }
    plan.push_back({.file = options.name + ".json", .content = EngineContent::Text, .bytes = 1500});
    return plan;
}

std::vector<std::string> engineWarnings(const EngineProfile& profile, const ProbeStatistics& probe)
{
    std::vector<std::string> warnings;
    float largest = 3.4e38f;
    for (const EngineFile& file : profile.files) {
        if (file.content == EngineContent::BabylonEnv)
            largest = std::min(largest, largestValue(PackedColor::Rgbd));
        else if (file.content == EngineContent::Atlas)
            largest = std::min(largest, largestValue(PackedColor::Rgbp));
        else if (isCube(file.content))
            largest = std::min(largest, traits(file.texels).largest);
    }
    const auto number = [](double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.3g", value);
        return std::string(text.data());
    };
    if (probe.largestValue > static_cast<double>(largest))
        warnings.push_back("The probe's brightest value, " + number(probe.largestValue) + ", is beyond what the files hold, " +
                           number(static_cast<double>(largest)) +
                           ": sharp reflections are clipped there. Rough levels and diffuse light "
                           "are filtered before that.");
    if (probe.sunShare > 0.25)
        warnings.push_back("A sun or lamp holds " + number(100.0 * probe.sunShare) +
                           " % of the light: engines cast no shadows from an "
                           "environment, so take it out and add it as a light of its own where shadows matter.");
    return warnings;
}

EngineExport exportForEngine(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options,
                             const std::filesystem::path& folder, const JobControl& job)
{
    if (probe.latlong() == nullptr)
        throw WorkError("an export for an engine needs the probe's texels in memory; scale the probe down");
    const EnvironmentMap& latlong = *probe.latlong();
    const std::vector<EngineFilePlan> plan = planEngineExport(profile, options, latlong.layout);
    const int size = checkedSize(profile, options.size);
    EngineExport done;
    done.warnings = timedStage(done.stages, "warnings", [&] { return engineWarnings(profile, statistics(latlong)); });
    Light light(probe, profile, options, size, job, done.stages);
    makeFolder(folder);
    for (size_t i = 0; i < profile.files.size(); ++i) {
        const std::filesystem::path path = folder / plan[i].file;
        makeFolder(path.parent_path());
        if (profile.files[i].content == EngineContent::Latlong) {
            const EnvironmentMap map = light.latlong(plan[i].size);
            timedStage(done.stages, "save " + plan[i].file, [&] { writeMap(path, {map}); });
        } else {
            const std::string bytes = fileBytes(profile.files[i], plan[i].file, light);
            timedStage(done.stages, "save " + plan[i].file, [&] { writeBytes(path, bytes); });
        }
        done.files.push_back(path);
    }
    done.sh = light.quality;
    const std::filesystem::path described = folder / (options.name + ".json");
    writeBytes(described, description(profile, options, plan, done));
    done.files.push_back(described);
    return done;
}

} // namespace mirrorball
