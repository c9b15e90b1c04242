#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/image/image_io.h"
#include "core/image/reproject.h"
#include "core/report/reference_samples.h"
#include "support/plain_sum.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// Whether a tolerance is kept: probes times lobes times tolerances, judged at even directions against a plain sum over the texels that
/// shares nothing with the library's filters (support/plain_sum.h).
///
///   tolerance_table [--lobes phong:3,ggx:0.1,diffuse] [--tolerances 1e-1,1e-5] [--method auto] [--directions 2000] [--size 64] [--to cube]
///                   [--height 128] [--broken] [--why] PROBE...
///
/// PROBE is a latlong file; --height averages it down first. --broken prints only the cells that do not keep the promise or
/// lie beyond what is predicted, --why the reason for the method. Exit status 1 if there is one.
namespace mirrorball {
namespace {

struct Arguments {
    std::vector<std::string> lobes{"phong:0",    "phong:0.5",   "phong:3",  "phong:4.5", "phong:7.3", "phong:30", "phong:300",
                                   "phong:3000", "phong:30000", "ggx:0.01", "ggx:0.1",   "ggx:0.3",   "ggx:1",    "diffuse"};
    std::vector<std::string> tolerances{"1e-1", "5e-2", "1e-2", "1e-3", "1e-5"};
    std::string method = "auto", to = "cube";
    int directions = 2000, size = 64, height = 0;
    bool onlyBroken = false, why = false;
    std::vector<std::string> probes{};
};

std::vector<std::string> split(const std::string& list)
{
    std::vector<std::string> words;
    std::istringstream text(list);
    for (std::string word; std::getline(text, word, ',');)
        words.push_back(word);
    return words;
}

Lobe parseLobe(const std::string& word)
{
    const size_t colon = word.find(':');
    const std::string kind = word.substr(0, colon);
    const double value = colon == std::string::npos ? 0.0 : std::stod(word.substr(colon + 1));
    if (kind == "diffuse")
        return diffuseLobe();
    if (kind == "phong")
        return phongLobe(value);
    if (kind == "ggx")
        return ggxLobe(value);
    throw InvalidArgument("--lobes: '" + word + "' is none; write phong:N, ggx:ALPHA or diffuse");
}

Arguments parse(int count, char** words)
{
    Arguments a;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto next = [&] { return i + 1 < count ? std::string(words[++i]) : throw InvalidArgument(word + ": a value is missing"); };
        if (word == "--lobes")
            a.lobes = split(next());
        else if (word == "--tolerances")
            a.tolerances = split(next());
        else if (word == "--method")
            a.method = next();
        else if (word == "--to")
            a.to = next();
        else if (word == "--directions")
            a.directions = std::stoi(next());
        else if (word == "--size")
            a.size = std::stoi(next());
        else if (word == "--height")
            a.height = std::stoi(next());
        else if (word == "--broken")
            a.onlyBroken = true;
        else if (word == "--why")
            a.why = true;
        else
            a.probes.push_back(word);
    }
    return a;
}

double cpuSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Texels of the target that hold even directions, each once.
std::vector<glm::ivec2> evenTexels(const MapLayout& target, int count)
{
    std::set<std::pair<int, int>> taken;
    std::vector<glm::ivec2> texels;
    for (const glm::dvec3& d : evenDirections(count)) {
        const glm::dvec2 p = coordinate(target, d);
        const int x = std::clamp(static_cast<int>(p.x), 0, target.width() - 1),
                  y = std::clamp(static_cast<int>(p.y), 0, target.height() - 1);
        if (taken.insert({x, y}).second)
            texels.emplace_back(x, y);
    }
    return texels;
}

int run(int count, char** words)
{
    const Arguments a = parse(count, words);
    const auto kind = parameterizationFromName(a.to);
    const auto method = methodFromName(a.method);
    if (!kind || !method || a.probes.empty())
        throw InvalidArgument("usage: tolerance_table [--lobes ...] [--tolerances ...] [--method NAME] [--to KIND] [--size N] PROBE...");
    const MapLayout target{*kind, a.size, 0};
    const std::vector<glm::ivec2> texels = evenTexels(target, a.directions);
    std::vector<glm::dvec3> directions;
    for (const glm::ivec2& t : texels)
        directions.push_back(texelDirection(target, t.x, t.y));

    std::printf("%-18s %-11s %-6s %-12s %5s | %8s %8s %8s %9s | %8s %8s %8s | %7s\n", "probe", "lobe", "t", "ran", "band", "rel_rms",
                "median", "p99", "least", "predict.", "median", "p99", "cpu s");
    int cells = 0, broken = 0, refused = 0, beyond = 0;
    for (const std::string& path : a.probes) {
        Image image = readImage(path);
        EnvironmentMap probe({Parameterization::Latlong, image.height, 0}, std::move(image));
        if (a.height > 0 && a.height < probe.image.height)
            probe = reproject(probe, {.target = {Parameterization::Latlong, a.height, 0}});
        for (const std::string& lobeWord : a.lobes) {
            const Lobe lobe = parseLobe(lobeWord);
            const std::vector<glm::dvec3> truth = test::plainlyUnresolved(lobe, probe.image.width)
                                                      ? test::plainLookups(probe.image, directions)
                                                      : test::plainSum(probe.image, lobe, directions);
            for (const std::string& word : a.tolerances) {
                const double tolerance = std::stod(word);
                FilterSource source(probe);
                ++cells;
                const std::string stem = std::filesystem::path(path).stem().string().substr(0, 18);
                const double start = cpuSeconds();
                PrefilterOutcome outcome;
                try {
                    outcome =
                        prefilter(source, {.lobe = lobe, .target = target, .method = *method, .tolerance = tolerance}, {.threads = 1});
                } catch (const InvalidArgument& why) {
                    ++refused;
                    std::printf("%-18s %-11s %-6s refused: %s\n", stem.c_str(), lobeWord.c_str(), word.c_str(), why.what());
                    continue;
                }
                const double seconds = cpuSeconds() - start;
                std::vector<glm::dvec3> values;
                for (const glm::ivec2& t : texels) {
                    const float* rgb = outcome.map.image.texel(t.x, t.y);
                    values.emplace_back(rgb[0], rgb[1], rgb[2]);
                }
                const test::PlainError e = test::plainError(values, truth);
                // What is promised is predicted from above, what is not within a factor of three.
                const PredictedErrors predicted = informedErrors(outcome, {.lobe = lobe, .target = target}, source);
                const auto isNear = [&](double measured, double said) {
                    return outcome.promised ? measured <= said : measured <= 3.0 * said && said <= 3.0 * measured;
                };
                const bool kept = !outcome.promised || e.keeps(tolerance);
                const bool under = isNear(e.relRms, predicted.relRms) &&
                                   (outcome.promised || (isNear(e.medianRel, predicted.medianRel) && isNear(e.p99Rel, predicted.p99Rel)));
                broken += kept ? 0 : 1;
                beyond += under ? 0 : 1;
                if (!a.onlyBroken || !kept || !under)
                    std::printf("%-18s %-11s %-6s %-12s %5d | %8.1e %8.1e %8.1e %9.1e | %8.1e %8.1e %8.1e | %7.3f %s%s\n", stem.c_str(),
                                lobeWord.c_str(), word.c_str(), outcome.filtered ? std::string(name(outcome.method)).c_str() : "lookup",
                                outcome.bandLimit, e.relRms, e.medianRel, e.p99Rel, e.least, predicted.relRms, predicted.medianRel,
                                predicted.p99Rel, seconds,
                                !outcome.promised ? "not promised"
                                : kept            ? "kept"
                                                  : "BROKEN",
                                under ? "" : ", beyond the prediction");
                if (a.why)
                    std::printf("    %s\n", outcome.why.c_str());
                std::fflush(stdout);
            }
        }
    }
    std::printf("%d cells: %d broken, %d refused, %d beyond their prediction\n", cells, broken, refused, beyond);
    return broken > 0 || beyond > 0 ? 1 : 0;
}

} // namespace
} // namespace mirrorball

int main(int count, char** words)
{
    try {
        return mirrorball::run(count, words);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tolerance_table: %s\n", error.what());
        return 2;
    }
}
