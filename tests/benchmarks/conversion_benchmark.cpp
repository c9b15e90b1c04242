// What people wait for when they convert, chain and filter sequences: CPU time and peak memory of whole programs and of the work in memory,
// each beside its floor. Makes its files in a temporary folder (2 GB) and removes them.
//   build/ci/bin/conversion_benchmark build/ci/bin/mirrorball [ROW]
// Rows named on the command line alone are measured, all without one. exrenvmap (package openexr) is compared where it is installed.

#include "core/filter/filter_source.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/reproject.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace mirrorball;

struct Cost {
    double seconds = 0.0; ///< CPU
    double megabytes = 0.0;
};

/// A command of its own: CPU time and peak memory from wait4(). Negative where it failed.
Cost commandCost(const std::vector<std::string>& words)
{
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> arguments;
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (std::freopen("/dev/null", "w", stdout))
            execvp(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return {-1.0, 0.0};
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024.0};
}

double cpuSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Median CPU time of a piece of work in this process.
double workCost(int runs, const std::function<void()>& work)
{
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const double start = cpuSeconds();
        work();
        times.push_back(cpuSeconds() - start);
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

/// The floor of what reads a file: decoding its rows, and nothing else.
double readingFloor(const std::filesystem::path& file)
{
    return workCost(3, [&] {
        const auto reader = openImage(file);
        const int width = reader->info().width, height = reader->info().height;
        std::vector<float> rows(static_cast<size_t>(width) * 16 * 3);
        for (int y = 0; y < height; y += 16)
            reader->readRows(y, std::min(16, height - y), rows.data());
    });
}

/// A Radiance picture of any size without holding it: one row of a sky, run-length coded, changed a little from row to row.
void writeLargeHdr(const std::filesystem::path& path, int height)
{
    const int width = 2 * height;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    std::fprintf(file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", height, width);
    std::vector<unsigned char> line;
    unsigned state = 1;
    for (int y = 0; y < height; ++y) {
        line = {2, 2, static_cast<unsigned char>(width >> 8), static_cast<unsigned char>(width & 255)};
        for (int plane = 0; plane < 4; ++plane)
            for (int x = 0; x < width;) {
                const int count = std::min(plane == 3 ? 127 : 128, width - x);
                if (plane == 3) { // exponents: runs
                    line.push_back(static_cast<unsigned char>(128 + count));
                    line.push_back(128);
                } else { // mantissas: noise
                    line.push_back(static_cast<unsigned char>(count));
                    for (int i = 0; i < count; ++i)
                        line.push_back(static_cast<unsigned char>(128 + ((state = state * 1664525u + 1013904223u) >> 25)));
                }
                x += count;
            }
        std::fwrite(line.data(), 1, line.size(), file);
    }
    std::fclose(file);
}

void print(const char* row, const Cost& cost, double floor, const char* goal)
{
    if (cost.seconds < 0.0)
        std::printf("%-44s failed\n", row);
    else
        std::printf("%-44s %9.4f s CPU %8.0f MB   floor %8.4f s (x %.1f)   goal %s\n", row, cost.seconds, cost.megabytes, floor,
                    cost.seconds / floor, goal);
    std::fflush(stdout);
}

/// The rows of the table.
class Rows {
public:
    explicit Rows(std::string program) : m_program(std::move(program)) { writeImage(m_hdr1k, m_k1.image); }

    void convert8k() const
    {
        const std::string file = (m_folder / "8k.hdr").string();
        writeLargeHdr(file, 4096);
        print("8k .hdr to a 1024 cube .exr", commandCost({m_program, "convert", file, "--to", "cube", "--size", "1024", "-o", m_out}),
              readingFloor(file), "1.0 s, 250 MB");
        print("8k .hdr ggx chain 256",
              commandCost({m_program, "filter", file, "--lobe", "ggx", "--mips", "--to", "cube", "--size", "256", "-o", m_out}),
              readingFloor(file), "1.5 s, 300 MB");
    }
    void convert4k() const
    {
        const std::string file = (m_folder / "4k.exr").string();
        const EnvironmentMap k4 = renderBuiltinProbe("sky", {Parameterization::Latlong, 2048, 0});
        writeMap(file, {k4});
        const double floor = readingFloor(file);
        const Cost ours = commandCost({m_program, "convert", file, "--to", "cube", "--size", "512", "-o", m_out});
        const Cost peer = commandCost({"exrenvmap", "-c", "-w", "512", file, (m_folder / "peer.exr").string()});
        const double work = workCost(3, [&] { reproject(k4, {.target = {Parameterization::Cube, 512, 0}}); });
        print("4k .exr to a 512 cube", ours, floor, "exrenvmap / 10");
        print("  exrenvmap", peer, floor, "-");
        print("  the work in memory", {work, 0.0}, 12e-9 * 8.4e6 / 10.0, "exrenvmap / 40");
    }
    void convert1k() const
    {
        print("1k to a 256 cube in memory",
              {workCost(9,
                        [&] {
                            reproject(m_k1, {.target = {Parameterization::Cube, 256, 0}});
                        }),
               0.0},
              0.36e-3, "0.020 s");
    }
    void chain() const
    {
        print("ggx chain 256 of 1k in memory",
              {workCost(5,
                        [&] {
                            FilterSource source(m_k1);
                            const MapLayout base{Parameterization::Cube, 256, 0};
                            for (int i = 0; i < levelCount(base); ++i) {
                                const double r = chainRoughness(i, levelCount(base));
                                prefilter(source, {.lobe = ggxLobe(r * r), .target = levelLayout(base, i)});
                            }
                        }),
               0.0},
              2.9e-3, "0.150 s");
    }
    void small() const
    {
        print("1k .hdr to a 128 cube .exr, whole process",
              commandCost(
                  {m_program, "filter", m_hdr1k, "--lobe", "phong", "--exponent", "50", "--to", "cube", "--size", "128", "-o", m_out}),
              readingFloor(m_hdr1k), "0.035 s");
    }
    void filterLarge(int height) const
    {
        const std::string file = (m_folder / "large.hdr").string();
        writeLargeHdr(file, height);
        print(height == 8192 ? "16k .hdr phong 50" : "24k .hdr phong 50",
              commandCost({m_program, "filter", file, "--lobe", "phong", "--exponent", "50", "--to", "cube", "--size", "128", "-o", m_out}),
              readingFloor(file), height == 8192 ? "1.2 s" : "3 s, 150 MB");
    }
    void frames() const
    {
        for (const int frames : {20, 200}) {
            for (int i = 1; i <= frames; ++i) {
                const std::filesystem::path link = m_folder / ("f." + std::to_string(1000 + i) + ".hdr");
                if (!std::filesystem::exists(link))
                    std::filesystem::create_hard_link(m_hdr1k, link);
            }
            const Cost cost = commandCost({m_program, "filter", (m_folder / "f.####.hdr").string(), "--lobe", "phong", "--exponent", "50",
                                           "--to", "cube", "--size", "128", "-o", (m_folder / "o.####.exr").string(), "--frames",
                                           "1001-" + std::to_string(1000 + frames)});
            print(frames == 20 ? "20 frames of 1k, phong 50 (a frame)" : "200 frames (a frame; memory as for 20)",
                  {cost.seconds / frames, cost.megabytes}, readingFloor(m_hdr1k), "2 cores / 60");
        }
    }

private:
    std::string m_program;
    test::TemporaryFolder m_folder{};
    EnvironmentMap m_k1 = renderBuiltinProbe("sky", {Parameterization::Latlong, 512, 0});
    std::string m_out = (m_folder / "out.exr").string(), m_hdr1k = (m_folder / "1k.hdr").string();
};

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fprintf(stderr, "conversion_benchmark PROGRAM [ROW]: name the mirrorball program to measure\n");
        return 2;
    }
    const Rows rows(argv[1]);
    const std::vector<std::pair<std::string, std::function<void()>>> table{
        {"convert-8k", [&] { rows.convert8k(); }},
        {"convert-4k", [&] { rows.convert4k(); }},
        {"convert-1k", [&] { rows.convert1k(); }},
        {"chain", [&] { rows.chain(); }},
        {"small", [&] { rows.small(); }},
        {"filter-16k", [&] { rows.filterLarge(8192); }},
        {"filter-24k", [&] { rows.filterLarge(12288); }},
        {"frames", [&] { rows.frames(); }},
    };
    for (const auto& [name, measure] : table)
        if (argc < 3 || name == argv[2])
            measure();
    return 0;
}
