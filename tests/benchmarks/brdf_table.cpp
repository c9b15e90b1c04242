#include "core/base/error.h"
#include "core/filter/brdf_stack.h"
#include "core/filter/lookup_table.h"
#include "core/image/image_io.h"
#include "core/image/reproject.h"
#include "core/report/brdf_errors.h"
#include "core/report/curve_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

/// What a material's map misses by method, roughness and angle of view, against the sum over every texel: one row a cell, as CSV.
///
///   brdf_table FOLDER [--rows N] [--plot OUT.png] [--full NAME]... [MODEL...]
///   default: ggx:alpha=%A cook-torrance:m=%A; %A stands for roughness squared
///
/// FOLDER holds .hdr latlongs of 1024 x 512; they are averaged to N rows (128) first. Each figure is rel_rms over the 256 frames of
/// BrdfFrames. "indoor" is the worst of the probes whose bright texels (bright_texels.h) hold less than a tenth of the light, "sunlit" that
/// of the others; "stack" is asked for 1e-2 and stands beside what it predicts ("kept": in how many probes the prediction held); "best"
/// counts the indoor probes in which five lookups are at least four times below the split sum, "worse" those in which they are above it by
/// more than 0.005. The plot is the first model's indoor columns, a panel a roughness.
///
/// With --full there is no such table but a row a cell and named probe, which is taken with all the texels of its file, over 64 frames.
namespace mirrorball {
namespace {

const JobControl oneThread{.threads = 1};
constexpr double roughnesses[] = {0.2, 0.3, 0.5, 0.7, 0.9};
constexpr double viewsDeg[] = {0.0, 30.0, 45.0, 60.0, 75.0, 80.0};
const std::vector<LookupChoice> choices{
    {LookupKind::Fitted, 5}, {LookupKind::Fitted, 3}, {LookupKind::SplitSum}, {LookupKind::Three}, {LookupKind::Filament}};
constexpr size_t five = 0, engine = 2;

struct NamedProbe {
    std::string name;
    EnvironmentMap map;
    FilterSource source;
    bool isSunlit;
};

/// @param rows  0: as many as a file has. @param names  of files; empty: all
std::vector<NamedProbe> probes(const std::filesystem::path& folder, int rows, const std::vector<std::string>& names)
{
    std::vector<std::filesystem::path> paths;
    for (const std::string& name : names)
        paths.push_back(folder / (name + ".hdr"));
    if (names.empty())
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".hdr")
                paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<NamedProbe> all;
    for (const auto& path : paths) {
        const Image image = readImage(path);
        EnvironmentMap map({Parameterization::Latlong, image.height, 0}, image);
        if (rows > 0)
            map = reproject(map, {.target = {Parameterization::Latlong, rows, 0}});
        FilterSource source(map);
        const double share = source.brightTexels(1).energy.g / (4.0 * pi * meanRadiance(map).g);
        all.push_back({path.stem().string(), std::move(map), std::move(source), share > 0.1});
        std::fprintf(stderr, "%s: bright texels hold %.3f of the light\n", path.stem().c_str(), share);
    }
    return all;
}

/// The worst probe's figures.
struct Worst {
    double stack = 0.0;
    std::vector<double> lookups = std::vector<double>(choices.size(), 0.0);
};

std::vector<LookupFit> fitsOf(const Brdf& brdf, double view)
{
    std::vector<LookupFit> fits;
    for (const LookupChoice& choice : choices)
        fits.push_back(lookupsFor(brdf, view, choice));
    return fits;
}

/// What one probe's maps miss.
struct Missed {
    StackPlan plan;
    double stack;
    std::vector<double> lookups;
};
Missed missed(NamedProbe& probe, const Brdf& brdf, double view, const std::vector<LookupFit>& fits, int frameRows)
{
    const BrdfFrames frames(probe.map, brdf, view, oneThread, frameRows);
    Missed result{.plan = planStack(brdf, view, 1e-2, probe.source, oneThread), .stack = 0.0, .lookups = {}};
    result.stack =
        frames.relRms([&](double azimuth) { return filterBrdfStack(probe.source, result.plan, azimuth, frames.layout(), 0.0, oneThread); });
    for (const LookupFit& fit : fits)
        result.lookups.push_back(frames.relRms(
            [&](double azimuth) { return filterBrdfLookups(probe.source, fit, azimuth, frames.layout(), 0.0, 1e-3, oneThread); }));
    return result;
}

/// @return of the indoor probes
Worst row(std::vector<NamedProbe>& all, const std::string& text, double roughness, double viewDeg)
{
    const Brdf brdf = brdfFromText(text);
    const double view = viewDeg * pi / 180.0;
    const std::vector<LookupFit> fits = fitsOf(brdf, view);
    Worst indoor, sunlit;
    double predicted = 0.0;
    int kept = 0, best = 0, worse = 0, indoors = 0, orders = 0, degrees = 0;
    for (NamedProbe& probe : all) {
        const Missed errors = missed(probe, brdf, view, fits, 8);
        Worst& worst = probe.isSunlit ? sunlit : indoor;
        worst.stack = std::max(worst.stack, errors.stack);
        for (size_t i = 0; i < fits.size(); ++i)
            worst.lookups[i] = std::max(worst.lookups[i], errors.lookups[i]);
        predicted = std::max(predicted, errors.plan.predictedError);
        kept += errors.stack <= errors.plan.predictedError;
        orders = std::max(orders, errors.plan.kernel.orders);
        degrees = std::max(degrees, errors.plan.kernel.bandLimit);
        if (!probe.isSunlit) {
            ++indoors;
            best += 4.0 * errors.lookups[five] <= errors.lookups[engine];
            worse += errors.lookups[five] > errors.lookups[engine] + 0.005;
        }
    }
    std::printf("%s,%.2f,%.0f,%.4f,%.4f,%.4f,%d/%zu,%d,%d", text.c_str(), roughness, viewDeg, indoor.stack, sunlit.stack, predicted, kept,
                all.size(), orders, degrees);
    for (const Worst* worst : {&indoor, &sunlit})
        for (const double error : worst->lookups)
            std::printf(",%.4f", error);
    std::printf(",%d/%d,%d\n", best, indoors, worse);
    std::fflush(stdout);
    return indoor;
}

/// A row a probe.
void fullRows(std::vector<NamedProbe>& all, const std::string& text, double roughness, double viewDeg)
{
    const Brdf brdf = brdfFromText(text);
    const double view = viewDeg * pi / 180.0;
    const std::vector<LookupFit> fits = fitsOf(brdf, view);
    for (NamedProbe& probe : all) {
        const Missed errors = missed(probe, brdf, view, fits, 4);
        std::printf("%s,%s,%.2f,%.0f,%.4f,%.4f,%d,%d", probe.name.c_str(), text.c_str(), roughness, viewDeg, errors.stack,
                    errors.plan.predictedError, errors.plan.kernel.orders, errors.plan.kernel.bandLimit);
        for (const double error : errors.lookups)
            std::printf(",%.4f", error);
        std::puts("");
        std::fflush(stdout);
    }
}

std::string withAlpha(std::string text, double roughness)
{
    if (const size_t at = text.find("%A"); at != std::string::npos)
        text.replace(at, 2, std::to_string(roughness * roughness));
    return text;
}

/// A panel a roughness, three in a row.
void savePlot(const std::string& path, const std::vector<std::vector<Worst>>& cells)
{
    std::vector<Image> panels;
    for (size_t r = 0; r < cells.size(); ++r) {
        char title[32];
        std::snprintf(title, sizeof title, "roughness %.1f", roughnesses[r]);
        CurvePlot plot{.title = title, .xTitle = "angle of view, degrees", .yTitle = "rel_rms", .width = 430, .height = 300};
        plot.xTicks.assign(std::begin(viewsDeg), std::end(viewsDeg));
        const auto add = [&](const std::string& label, size_t hue, auto&& of) {
            Curve curve{.label = label, .color = curveColor(hue)};
            for (size_t v = 0; v < cells[r].size(); ++v)
                curve.points.emplace_back(viewsDeg[v], of(cells[r][v]));
            plot.curves.push_back(std::move(curve));
        };
        add("exact", 5, [](const Worst& worst) { return worst.stack; });
        for (size_t i = 0; i < choices.size(); ++i)
            add(describe(choices[i]), i, [i](const Worst& worst) { return worst.lookups[i]; });
        panels.push_back(curvePicture(plot));
    }
    const int columns = 3, width = panels[0].width, height = panels[0].height,
              rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    Image sheet(columns * width, rows * height);
    std::fill(sheet.texels.begin(), sheet.texels.end(), 1.0f);
    for (size_t i = 0; i < panels.size(); ++i)
        for (int y = 0; y < height; ++y)
            std::copy_n(panels[i].texel(0, y), 3 * width,
                        sheet.texel(static_cast<int>(i) % columns * width, static_cast<int>(i) / columns * height + y));
    writeImage(path, sheet, {.encoding = Encoding::Display});
}

int run(const std::vector<std::string>& words)
{
    std::vector<std::string> models, full;
    std::string plot;
    int rows = 128;
    for (size_t i = 1; i < words.size(); ++i) {
        if (i + 1 < words.size() && words[i] == "--plot")
            plot = words[++i];
        else if (i + 1 < words.size() && words[i] == "--rows")
            rows = std::stoi(words[++i]);
        else if (i + 1 < words.size() && words[i] == "--full")
            full.push_back(words[++i]);
        else
            models.push_back(words[i]);
    }
    if (models.empty())
        models = {"ggx:alpha=%A", "cook-torrance:m=%A"};
    std::vector<NamedProbe> all = probes(words[0], full.empty() ? rows : 0, full);
    if (!full.empty()) {
        std::printf("probe,model,roughness,view,stack,stack predicted,orders,degrees");
        for (const LookupChoice& choice : choices)
            std::printf(",%s", describe(choice).c_str());
        std::puts("");
        for (const std::string& model : models)
            for (const double roughness : roughnesses)
                for (const double view : viewsDeg)
                    fullRows(all, withAlpha(model, roughness), roughness, view);
        return 0;
    }
    std::printf("model,roughness,view,stack indoor,stack sunlit,stack predicted,kept,orders,degrees");
    for (const char* place : {"indoor", "sunlit"})
        for (const LookupChoice& choice : choices)
            std::printf(",%s %s", describe(choice).c_str(), place);
    std::puts(",best,worse");
    for (size_t m = 0; m < models.size(); ++m) {
        std::vector<std::vector<Worst>> cells;
        for (const double roughness : roughnesses) {
            cells.emplace_back();
            for (const double view : viewsDeg)
                cells.back().push_back(row(all, withAlpha(models[m], roughness), roughness, view));
        }
        if (m == 0 && !plot.empty())
            savePlot(plot, cells);
    }
    return 0;
}

} // namespace
} // namespace mirrorball

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fputs("brdf_table FOLDER [--rows N] [--plot OUT.png] [--full NAME]... [MODEL...]\n", stderr);
        return 2;
    }
    try {
        return mirrorball::run({argv + 1, argv + argc});
    } catch (const mirrorball::Error& e) {
        std::fprintf(stderr, "brdf_table: %s\n", e.what());
        return 1;
    }
}
