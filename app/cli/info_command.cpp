#include "command.h"

#include "core/image/probe_file.h"
#include "core/image/probe_statistics.h"
#include "core/preview/mesh_file.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, from;
    int threads = 0;
    bool json = false;
};

void tellMesh(const Options& o)
{
    const preview::MeshFacts facts = preview::readMeshFile(o.probe, jobWithProgress("info", o.threads)).facts;
    if (o.json)
        std::printf("%s\n", nlohmann::json{{"mesh", o.probe},
                                           {"triangles", facts.triangles},
                                           {"dropped", facts.dropped},
                                           {"extent", facts.extent},
                                           {"description", describe(facts)}}
                                .dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
                                .c_str());
    else
        std::printf("mesh              %s\n", describe(facts).c_str());
}

void run(const Options& o)
{
    if (preview::isMeshFile(o.probe))
        return tellMesh(o);
    ReadProbeOptions read;
    if (!o.from.empty())
        read.from = parseKind("--from", o.from);
    const Probe probe = readProbe(o.probe, read, jobWithProgress("info", o.threads));
    const ProbeStatistics s = statistics(probe.map);
    const MapLayout& layout = probe.map.layout;
    const std::string kind(name(layout.kind));
    if (o.json) {
        const nlohmann::json record{{"probe", o.probe},
                                    {"width", probe.map.image.width},
                                    {"height", probe.map.image.height},
                                    {"parameterization", kind},
                                    {"size", layout.size},
                                    {"border", layout.border},
                                    {"certain", probe.certain},
                                    {"why", probe.origin},
                                    {"min_luminance", s.minLuminance},
                                    {"max_luminance", s.maxLuminance},
                                    {"mean_luminance", s.meanLuminance},
                                    {"mean_radiance", {s.meanRadiance.r, s.meanRadiance.g, s.meanRadiance.b}},
                                    {"brightest_direction", {s.brightestDirection.x, s.brightestDirection.y, s.brightestDirection.z}},
                                    {"largest_value", s.largestValue},
                                    {"beyond_half", s.beyondHalf},
                                    {"sun_share", s.sunShare},
                                    {"nan", probe.repaired.nan},
                                    {"inf", probe.repaired.positiveInfinity + probe.repaired.negativeInfinity},
                                    {"negative", probe.repaired.negative}};
        std::printf("%s\n", record.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        return;
    }
    std::printf("size              %d x %d\n", probe.map.image.width, probe.map.image.height);
    std::printf("parameterization  %s%s (%s)\n", kind.c_str(), probe.certain ? "" : ", a guess", probe.origin.c_str());
    std::printf("luminance         %.6g to %.6g, mean %.6g\n", s.minLuminance, s.maxLuminance, s.meanLuminance);
    std::printf("mean radiance     %.6g %.6g %.6g\n", s.meanRadiance.r, s.meanRadiance.g, s.meanRadiance.b);
    std::printf("brightest         direction %.4f %.4f %.4f\n", s.brightestDirection.x, s.brightestDirection.y, s.brightestDirection.z);
    std::printf("sun               the brightest 0.01 %% of the texels hold %.2f %% of the energy\n", 100.0 * s.sunShare);
    std::printf("half float        %lld values beyond 65504\n", static_cast<long long>(s.beyondHalf));
    std::printf("texels            %s\n", describe(probe.repaired).c_str());
}

} // namespace

void addInfoCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "info", "Tell what a probe holds: size, parameterization, range, sun, broken texels; of a mesh its triangles and size");
    command->add_option("PROBE", o->probe, "file, builtin:NAME or a mesh file")->required();
    command->add_option("--from", o->from, "parameterization, where it is not to be found out (KIND)");
    command->add_flag("--json", o->json, "as JSON");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
