#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/preview/paraboloid_blur.h"
#include "core/report/error_metrics.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string_view>

/// What the exact kernel of the paraboloid method gains over the published one, probe by probe and exponent by exponent: predicted and
/// measured error against the spectral method at a tolerance of 1e-6, and the CPU time of all threads. Latlong probes of 1024 x 512 are
/// named on the command line; without one it is the built-in sky. paraboloid_table PROBE.hdr... Or, large maps: paraboloid_table 512
namespace mirrorball {
namespace {

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Variant {
    const char* name;
    ParaboloidKnobs knobs;
};

void printRow(FilterSource& source, double exponent, const Variant& variant)
{
    PrefilterOptions options{
        .lobe = phongLobe(exponent), .target = {Parameterization::Cube, 64, 0}, .method = Method::Spectral, .tolerance = 1e-6};
    const EnvironmentMap reference = prefilter(source, options).map;
    options.method = Method::Paraboloid;
    options.knobs.paraboloid = variant.knobs;
    const double start = cpuSeconds();
    const PrefilterOutcome outcome = prefilter(source, options);
    const double seconds = cpuSeconds() - start;
    const ErrorMetrics error = errorMetrics(outcome.map, reference);
    std::printf("%8g  %-24s  %9.1e  %9.1e  %9.1e  %9.1e  %7.0f ms\n", exponent, variant.name, outcome.predicted.relRms, error.relRms,
                error.maxAbs, error.p99Rel, 1e3 * seconds);
    std::fflush(stdout);
}

void printTable(EnvironmentMap probe, preview::ParaboloidBlur& device)
{
    FilterSource source(std::move(probe));
    source.useParaboloidDevice(std::shared_ptr<ParaboloidDevice>(&device, [](ParaboloidDevice*) {}));
    std::printf("exponent  %-24s  predicted    rel_rms    max_abs    p99_rel        CPU\n", "kernel (clamp, size)");
    for (const double exponent : {10.0, 50.0, 100.0, 250.0, 500.0})
        for (const Variant& variant : {Variant{"published (0.1, 7)", {.kernel = ParaboloidKernel::Blended}},
                                       Variant{"exact (0.1, 7)", {.clamp = 0.1, .largestKernel = 7}}, Variant{"exact (0.001, 17)", {}},
                                       Variant{"exact (1e-5, 41)", {.clamp = 1e-5, .largestKernel = 41}}})
            printRow(source, exponent, variant);
}

/// Halves of 512 texels, half a million directions: CPU time and seconds that pass, with the device and on the CPU, and the error.
void printHalves(EnvironmentMap probe, const std::shared_ptr<ParaboloidDevice>& device)
{
    FilterSource source(std::move(probe));
    PrefilterOptions options{
        .lobe = phongLobe(50), .target = {Parameterization::Paraboloid, 512, 0}, .method = Method::Spectral, .tolerance = 1e-6};
    const EnvironmentMap reference = prefilter(source, options).map;
    options.method = Method::Paraboloid;
    std::printf("phong 50 to halves of 512             device: CPU      wall    without: CPU      wall    rel_rms\n");
    for (const Variant& variant : {Variant{"published (0.1, 7)", {.kernel = ParaboloidKernel::Blended}}, Variant{"exact (0.001, 17)", {}},
                                   Variant{"exact (1e-5, 41)", {.clamp = 1e-5, .largestKernel = 41}}}) {
        options.knobs.paraboloid = variant.knobs;
        std::printf("%-36s", variant.name);
        for (const auto& on : {device, std::shared_ptr<ParaboloidDevice>()}) {
            source.useParaboloidDevice(on);
            const auto start = std::chrono::steady_clock::now();
            const double cpuStart = cpuSeconds();
            const PrefilterOutcome outcome = prefilter(source, options);
            const double cpu = cpuSeconds() - cpuStart;
            std::printf("  %6.2f s  %6.2f s", cpu, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            if (!on)
                std::printf("   %9.1e\n", errorMetrics(outcome.map, reference).relRms);
        }
        std::fflush(stdout);
    }
}

} // namespace
} // namespace mirrorball

int main(int count, char** arguments)
{
    using namespace mirrorball;
    preview::ParaboloidBlur device;
    std::printf("%s\n", device.description().c_str());
    if (count == 2 && std::string_view(arguments[1]) == "512") {
        printHalves(renderBuiltinProbe("sky"), std::shared_ptr<ParaboloidDevice>(&device, [](ParaboloidDevice*) {}));
        return 0;
    }
    if (count < 2)
        printTable(renderBuiltinProbe("sky"), device);
    for (int i = 1; i < count; ++i) {
        std::printf("%s\n", arguments[i]);
        const Image image = readImage(arguments[i]);
        printTable(EnvironmentMap({Parameterization::Latlong, image.height, 0}, image), device);
    }
}
