#include "core/base/error.h"
#include "core/filter/brdf_lookups.h"
#include "core/filter/brdf_stack.h"
#include "core/filter/brdf_sum.h"
#include "core/image/image_io.h"
#include "core/image/reproject.h"
#include "core/report/error_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

/// What a material's map misses by method, roughness and angle of view, against the sum over every texel: one row a cell, as CSV.
///
///   brdf_table FOLDER [MODEL...]     default: ggx:alpha=%A cook-torrance:m=%A; %A stands for roughness squared
///
/// FOLDER holds .hdr latlongs of 1024 x 512; they are resampled to 256 x 128 first. Each figure is rel_rms over 256 frames: the directions
/// of a latlong map of 16 x 8, weighted by solid angle, at two azimuths of the normal. "indoor" is the worst of the probes whose bright
/// texels (bright_texels.h) hold less than a tenth of the light, "sunlit" that of the others; "stack" is asked for 1e-2 and stands beside
/// what it predicts ("kept": in how many probes the prediction held); "best" counts the indoor probes in which five lookups are at least
/// four times below the split sum.
namespace mirrorball {
namespace {

const MapLayout frames{Parameterization::Latlong, 8, 0};
constexpr double azimuths[] = {0.7, 3.9};
const JobControl oneThread{.threads = 1};

struct NamedProbe {
    std::string name;
    EnvironmentMap map;
    FilterSource source;
    bool isSunlit;
};

std::vector<NamedProbe> probes(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".hdr")
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<NamedProbe> all;
    for (const auto& path : paths) {
        const Image image = readImage(path);
        const MapLayout layout{Parameterization::Latlong, 128, 0};
        EnvironmentMap map = reproject(EnvironmentMap({Parameterization::Latlong, image.height, 0}, image), {.target = layout});
        FilterSource source(map);
        const double share = source.brightTexels(1).energy.g / (4.0 * pi * meanRadiance(map).g);
        all.push_back({path.stem().string(), std::move(map), std::move(source), share > 0.1});
        std::fprintf(stderr, "%s: bright texels hold %.3f of the light\n", path.stem().c_str(), share);
    }
    return all;
}

/// rel_rms over both azimuths.
template <typename Make>
double errorOf(const std::vector<EnvironmentMap>& truth, Make&& make)
{
    double sum = 0.0;
    for (size_t i = 0; i < truth.size(); ++i)
        sum += std::pow(errorMetrics(make(azimuths[i]), truth[i]).relRms, 2.0);
    return std::sqrt(sum / static_cast<double>(truth.size()));
}

struct Worst {
    double stack = 0.0, five = 0.0, three = 0.0, engine = 0.0;
};

void row(std::vector<NamedProbe>& all, const std::string& text, double roughness, double viewDeg)
{
    const Brdf brdf = brdfFromText(text);
    const double view = viewDeg * pi / 180.0;
    const LookupFit five = fitLookups(brdf, view, 5), three = fitLookups(brdf, view, 3), engine = splitSum(brdf, view);
    Worst indoor, sunlit;
    double predicted = 0.0;
    int kept = 0, best = 0, indoors = 0, orders = 0, degrees = 0;
    for (NamedProbe& probe : all) {
        std::vector<EnvironmentMap> truth;
        for (const double azimuth : azimuths)
            truth.push_back(filterBrdfSum(probe.map, brdf, {view, azimuth}, frames, 0.0, oneThread));
        const StackPlan plan = planStack(brdf, view, 1e-2, probe.source, oneThread);
        const double stack = errorOf(truth, [&](double a) { return filterBrdfStack(probe.source, plan, a, frames, 0.0, oneThread); });
        const auto lookups = [&](const LookupFit& fit) {
            return errorOf(truth, [&](double a) { return filterBrdfLookups(probe.source, fit, a, frames, 0.0, 1e-3, oneThread); });
        };
        const double e5 = lookups(five), e3 = lookups(three), e1 = lookups(engine);
        Worst& worst = probe.isSunlit ? sunlit : indoor;
        worst = {std::max(worst.stack, stack), std::max(worst.five, e5), std::max(worst.three, e3), std::max(worst.engine, e1)};
        predicted = std::max(predicted, plan.predictedError);
        kept += stack <= plan.predictedError;
        orders = std::max(orders, plan.kernel.orders);
        degrees = std::max(degrees, plan.kernel.bandLimit);
        if (!probe.isSunlit) {
            ++indoors;
            best += 4.0 * e5 <= e1;
        }
    }
    std::printf("%s,%.2f,%.0f,%.4f,%.4f,%.4f,%d/%zu,%d,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%d/%d\n", text.c_str(), roughness, viewDeg,
                indoor.stack, sunlit.stack, predicted, kept, all.size(), orders, degrees, indoor.five, indoor.three, indoor.engine,
                sunlit.five, sunlit.three, sunlit.engine, best, indoors);
    std::fflush(stdout);
}

int run(int argc, char** argv)
{
    std::vector<std::string> models(argv + std::min(argc, 2), argv + argc);
    if (models.empty())
        models = {"ggx:alpha=%A", "cook-torrance:m=%A"};
    std::vector<NamedProbe> all = probes(argv[1]);
    std::puts("model,roughness,view,stack indoor,stack sunlit,stack predicted,kept,orders,degrees,K=5 indoor,K=3 indoor,split sum indoor,"
              "K=5 sunlit,K=3 sunlit,split sum sunlit,best");
    for (const std::string& model : models)
        for (const double roughness : {0.3, 0.5, 0.7, 0.9})
            for (const double view : {0.0, 30.0, 45.0, 60.0, 75.0}) {
                std::string text = model;
                if (const size_t at = text.find("%A"); at != std::string::npos)
                    text.replace(at, 2, std::to_string(roughness * roughness));
                row(all, text, roughness, view);
            }
    return 0;
}

} // namespace
} // namespace mirrorball

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fputs("brdf_table FOLDER [MODEL...]\n", stderr);
        return 2;
    }
    try {
        return mirrorball::run(argc, argv);
    } catch (const mirrorball::Error& e) {
        std::fprintf(stderr, "brdf_table: %s\n", e.what());
        return 1;
    }
}
