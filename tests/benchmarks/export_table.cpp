#include "core/scene/export.h"
#include "core/scene/export_estimate.h"
#include "core/scene/scene_maps.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

/// The time that an export is told to take (export_estimate.h) beside the CPU time that it takes in memory and on disk, kind by kind: the
/// median of five runs, each in a folder of its own. Both are those of a program that has loaded what a format needs. export_table [PROBE]
namespace mirrorball {
namespace {

double cpuSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Row {
    const char* what;
    ExportTarget target;
};

/// @return estimated over taken
double printRow(const std::string& probe, const Row& row)
{
    Scene scene;
    scene.probe.source = probe;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 100.0};
    scene.material.sphereMap.source = "jade";
    scene.exports = {row.target};
    std::vector<double> taken;
    for (int run = 0; run < 5; ++run) {
        const test::TemporaryFolder folder;
        const double start = cpuSeconds();
        exportScene(scene, folder.path(), {}, {});
        taken.push_back(cpuSeconds() - start);
    }
    std::sort(taken.begin(), taken.end());
    const Plan plan = makePlan(scene, probeLayout(scene), {.picture = false, .exports = std::vector<std::string>{}});
    const ExportEstimate estimate = estimateExports(plan).front();
    const double expected = estimate.seconds + (estimate.isPainted ? 0.0 : plan.sharedSeconds);
    std::printf("%-44s  %7.3f s  %7.3f s  x %.2f\n", row.what, expected, taken[2], taken[2] / expected);
    std::fflush(stdout);
    return taken[2] / expected;
}

} // namespace
} // namespace mirrorball

int main(int count, char** arguments)
{
    using namespace mirrorball;
    const std::string probe = count > 1 ? arguments[1] : "builtin:sky";
    std::printf("%-44s   expected   CPU time  ratio\n", probe.c_str());
    const std::vector<Row> rows{
        {"environment, 512 cube with mips, .exr", {.name = "a", .kind = ExportKind::Source, .size = 512, .mips = true}},
        {"environment, 1024 latlong, .hdr",
         {.name = "a", .kind = ExportKind::Source, .parameterization = Parameterization::Latlong, .size = 512, .file = "a.hdr"}},
        {"phong 100, 256 cube, .exr", {.name = "a", .kind = ExportKind::Specular, .size = 256}},
        {"phong 100, 256 cube, .exr half", {.name = "a", .kind = ExportKind::Specular, .size = 256, .half = true}},
        {"phong 100, 256 cube, .tif", {.name = "a", .kind = ExportKind::Specular, .size = 256, .file = "a.tif"}},
        {"phong 100, 256 cube, .ktx2", {.name = "a", .kind = ExportKind::Specular, .size = 256, .file = "a.ktx2"}},
        {"diffuse, 64 cube, .exr", {.name = "a", .kind = ExportKind::Diffuse, .size = 64}},
        {"ggx chain, 256 cube, .exr", {.name = "a", .kind = ExportKind::Chain, .size = 256}},
        {"painted, 1024, .png", {.name = "a", .kind = ExportKind::Painted, .size = 1024, .file = "a.png"}},
        {"painted with levels, 512, .exr", {.name = "a", .kind = ExportKind::Painted, .size = 512, .mips = true}},
    };
    int within = 0;
    for (const Row& row : rows) {
        const double ratio = printRow(probe, row);
        within += ratio > 0.5 && ratio < 2.0;
    }
    std::printf("%d of %zu within a factor of 2\n", within, rows.size());
}
