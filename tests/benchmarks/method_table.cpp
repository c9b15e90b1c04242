#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The filtering methods against each other on 1k probes: what each takes and misses, beside what was predicted.
///
///   method_table methods [FOLDER]    one probe: every method and lobe (error and seconds, measured and predicted)
///   method_table auto [FOLDER]       every probe, phong 10, 50, 500, ggx 0.3 and diffuse at tolerance 1e-3: does auto meet it, and who
///   would have been faster method_table ratios [FOLDER]     spectral against importance at equal error, and against the reference sum
///
/// FOLDER holds .hdr latlongs of 1024 x 512; without it the built-in sky stands for them. Seconds are those of the CPU on one thread, the
/// least of a few runs, so that other work on the machine matters little. Errors are rel_rms over the whole map against the
/// spectral method at 1e-7, which the tests hold to the reference sum.
namespace mirrorball {
namespace {

const MapLayout cube128{Parameterization::Cube, 128, 0};
const MapLayout cube16{Parameterization::Cube, 16, 0};
const JobControl oneThread{.threads = 1};

struct NamedProbe {
    std::string name;
    EnvironmentMap map;
};

std::vector<NamedProbe> probes(const char* folder)
{
    std::vector<NamedProbe> all;
    if (folder) {
        std::vector<std::filesystem::path> paths;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".hdr")
                paths.push_back(entry.path());
        std::sort(paths.begin(), paths.end());
        for (const auto& path : paths)
            all.push_back({path.stem().string(), EnvironmentMap({Parameterization::Latlong, 512, 0}, readImage(path))});
    } else {
        all.push_back({"sky", renderBuiltinProbe("sky")});
    }
    return all;
}

double cpuSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Measured {
    double seconds = 0.0;
    double relRms = 0.0;
    PrefilterOutcome outcome{};
};

/// The whole job from a probe in memory, nothing known of it yet. @param exact  the map it should be
Measured measure(const EnvironmentMap& probe, const PrefilterOptions& options, const EnvironmentMap& exact, int runs)
{
    Measured m{.seconds = 1e300};
    for (int i = 0; i < runs; ++i) {
        FilterSource source(probe);
        const double start = cpuSeconds();
        m.outcome = prefilter(source, options, oneThread);
        m.seconds = std::min(m.seconds, cpuSeconds() - start);
        if (m.seconds > 1.0)
            break;
    }
    m.relRms = errorMetrics(m.outcome.map, exact).relRms;
    return m;
}

EnvironmentMap exactMap(const EnvironmentMap& probe, PrefilterOptions options)
{
    options.method = Method::Spectral;
    options.tolerance = 1e-7;
    FilterSource source(probe);
    return prefilter(source, options, oneThread).map;
}

struct Setting {
    Method method;
    double tolerance = 1e-3;
    MethodKnobs knobs{};
    MapLayout target = cube128;
};

std::string describe(const Setting& s)
{
    std::string text(name(s.method));
    char number[32];
    std::snprintf(number, sizeof number, " %.0e", s.tolerance);
    if (s.method == Method::Importance)
        text += " " + std::to_string(s.knobs.samples);
    else if (s.method == Method::Spectral || s.method == Method::Direct || s.method == Method::Hierarchical)
        text += number;
    if (s.method == Method::Mip && s.knobs.mipFiltering == MipFiltering::PerFace)
        text += " per face";
    return text;
}

void printMethods(const std::vector<NamedProbe>& all)
{
    std::vector<Setting> settings;
    for (const double tolerance : {1e-2, 1e-3, 1e-5})
        settings.push_back({.method = Method::Spectral, .tolerance = tolerance});
    for (const double tolerance : {1e-2, 1e-3, 1e-4})
        settings.push_back({.method = Method::Hierarchical, .tolerance = tolerance, .target = cube16});
    settings.push_back({.method = Method::Direct, .target = cube16});
    for (const int samples : {64, 1024, 4096, 16384})
        settings.push_back({.method = Method::Importance, .knobs = {.samples = samples}, .target = cube16});
    settings.push_back({.method = Method::Mip});
    settings.push_back({.method = Method::Mip, .knobs = {.mipFiltering = MipFiltering::PerFace}});
    settings.push_back({.method = Method::Sh9});
    for (const NamedProbe& probe : all) {
        std::printf("%s (to a cube of 128, or of 16 where marked *)\n%-11s %-20s %11s %11s %7s %11s %11s %7s\n", probe.name.c_str(), "lobe",
                    "method", "seconds", "predicted", "ratio", "rel_rms", "predicted", "ratio");
        for (const Lobe& lobe : {phongLobe(10), phongLobe(50), phongLobe(500), ggxLobe(0.09), diffuseLobe()})
            for (const Setting& s : settings) {
                const PrefilterOptions options{
                    .lobe = lobe, .target = s.target, .method = s.method, .tolerance = s.tolerance, .knobs = s.knobs};
                if (!refusal(s.method, options, {.width = probe.map.image.width}).empty())
                    continue;
                if (s.method == Method::Direct && LobeShape(lobe).halfWidth() > 0.06)
                    continue; // minutes
                const Measured m = measure(probe.map, options, exactMap(probe.map, options), 3);
                const double seconds = predictedSeconds(s.method, options, {.width = probe.map.image.width});
                FilterSource source(probe.map);
                const double error = informedErrors(m.outcome, options, source, oneThread).relRms;
                std::printf("%-11s %-20s %11.3g %11.3g %7.2f %11.3g %11.3g %7.2f\n", describe(lobe).c_str(),
                            (describe(s) + (s.target == cube16 ? " *" : "")).c_str(), m.seconds, seconds, m.seconds / seconds, m.relRms,
                            error, m.relRms / error);
                std::fflush(stdout);
            }
    }
}

/// A method is worth a full measurement only when a sixty-fourth of its lookups is not slower already than what it has to beat.
void printAuto(const std::vector<NamedProbe>& all)
{
    constexpr double tolerance = 1e-3;
    std::printf("%-32s %-10s %-10s %9s %9s   %s\n", "probe", "lobe", "auto", "ms", "rel_rms", "others that meet 1e-3: ms (rel_rms)");
    double worst = 0.0;
    bool allMeet = true;
    for (const NamedProbe& probe : all)
        for (const Lobe& lobe : {phongLobe(10), phongLobe(50), phongLobe(500), ggxLobe(0.3), diffuseLobe()}) {
            PrefilterOptions options{.lobe = lobe, .target = cube128, .tolerance = tolerance};
            const EnvironmentMap exact = exactMap(probe.map, options);
            const Measured chosen = measure(probe.map, options, exact, 5);
            std::printf("%-32s %-10s %-10s %9.2f %9.2e  ", probe.name.c_str(), describe(options.lobe).c_str(),
                        std::string(name(chosen.outcome.method)).c_str(), chosen.seconds * 1e3, chosen.relRms);
            allMeet = allMeet && chosen.relRms <= tolerance;
            double fastest = chosen.seconds;
            for (const Method method : allMethods) {
                options.method = method;
                if (method == Method::Auto || method == Method::Reference || !refusal(method, options, {}).empty())
                    continue;
                PrefilterOptions few = options;
                few.target = cube16;
                for (int samples = 64; samples <= 65536;
                     samples *= 4) { // one turn but for importance, two for the methods with a tolerance
                    few.knobs.samples = options.knobs.samples = samples;
                    few.tolerance = options.tolerance = samples == 64 ? tolerance : 10.0 * tolerance; // it may meet more than asked for
                    if (measure(probe.map, few, exactMap(probe.map, few), 1).seconds > 1.5 * chosen.seconds)
                        break;
                    const Measured m = measure(probe.map, options, exact, 5);
                    if (m.relRms <= tolerance) {
                        std::printf(" %s %.2f (%.1e)", std::string(name(method)).c_str(), m.seconds * 1e3, m.relRms);
                        fastest = std::min(fastest, m.seconds);
                    }
                    if (method != Method::Importance && samples > 64)
                        break;
                }
            }
            worst = std::max(worst, chosen.seconds / fastest);
            std::printf("\n");
            std::fflush(stdout);
        }
    std::printf("auto meets %.0e in every case: %s; slower than the fastest that meets it by at most %.2f\n", tolerance,
                allMeet ? "yes" : "NO", worst);
}

void printRatios(const std::vector<NamedProbe>& all)
{
    constexpr double wanted = 1e-3;
    std::printf("%-32s %-10s %12s %12s %22s %12s %12s\n", "probe", "lobe", "spectral ms", "reference s", "importance s", "ref/spectral",
                "imp/spectral");
    for (const NamedProbe& probe : all)
        for (const double n : {10.0, 50.0, 500.0}) {
            PrefilterOptions options{.lobe = phongLobe(n), .target = cube128, .method = Method::Spectral, .tolerance = wanted};
            const Measured spectral = measure(probe.map, options, exactMap(probe.map, options), 5);

            std::vector<glm::dvec3> some; // of the target's directions; the sum is the same work for each
            for (int x = 0; x < 128; x += 8)
                some.push_back(texelDirection(cube128, x, 300));
            const double start = cpuSeconds();
            referenceSum(probe.map, options.lobe, some, oneThread);
            const double reference = (cpuSeconds() - start) * 128 * 768 / static_cast<double>(some.size());

            options.method = Method::Importance;
            options.target = cube16;
            const EnvironmentMap exact = exactMap(probe.map, options);
            double importance = 0.0, error = 1.0;
            int samples = 128;
            while (error > wanted && samples < 65536) {
                samples *= 2;
                options.knobs.samples = samples;
                FilterSource source(probe.map);
                const double prepare = cpuSeconds();
                source.lookupPyramid(oneThread);
                const double sample = cpuSeconds();
                error = errorMetrics(prefilter(source, options, oneThread).map, exact).relRms;
                importance = (sample - prepare) + (cpuSeconds() - sample) * 64.0; // 64 times as many texels in a cube of 128
            }
            char text[64];
            std::snprintf(text, sizeof text, "%s%.2f (%d: %.1e)", error > wanted ? "> " : "", importance, samples, error);
            std::printf("%-32s %-10s %12.2f %12.1f %22s %12.0f %12.0f\n", probe.name.c_str(), describe(options.lobe).c_str(),
                        spectral.seconds * 1e3, reference, text, reference / spectral.seconds, importance / spectral.seconds);
            std::fflush(stdout);
        }
}

} // namespace
} // namespace mirrorball

int main(int argc, char** argv)
{
    using namespace mirrorball;
    const std::string what = argc > 1 ? argv[1] : "";
    try {
        const std::vector<NamedProbe> all = probes(argc > 2 ? argv[2] : nullptr);
        if (what == "methods")
            printMethods({all.front()});
        else if (what == "every-method")
            printMethods(all);
        else if (what == "auto")
            printAuto(all);
        else if (what == "ratios")
            printRatios(all);
        else {
            std::fprintf(stderr, "method_table: what to print? methods, every-method, auto or ratios; then a folder of .hdr probes\n");
            return 2;
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "method_table: %s\n", e.what());
        return 1;
    }
    return 0;
}
