#include "command.h"
#include "reading_options.h"

#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/probe_file.h"
#include "core/image/reproject.h"

#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, to;
    ReadingOptions reading;
    int size = 0, border = 0, threads = 0;
    double yawDeg = 0.0;
    bool mips = false, half = false;
};

void run(const Options& o)
{
    const MapTarget target = parseTarget(o.to, o.size, o.border);
    checkMapFile(o.out, target.layout);
    ReadProbeOptions read{.reading = o.reading.parse()};
    const glm::dmat3 turn = orientation(read.reading); // left to the resampling, which happens only once then
    read.reading.mirror = MirrorAxis::None;
    read.reading.rotateDeg = glm::dvec3(0.0);
    const JobControl job = jobWithProgress("convert", o.threads);
    const Probe probe = readProbe(o.probe, read, job);
    printNotes(o.probe, probe.notes);
    EnvironmentMap map = reproject(probe.map, {.target = target.layout, .yaw = radians(o.yawDeg), .turn = turn}, job);
    std::vector<EnvironmentMap> levels;
    if (o.mips)
        levels = buildMipPyramid(map, job).levels;
    else
        levels.push_back(std::move(map));
    writeMap(o.out, levels, {.sampleType = o.half ? SampleType::Half : SampleType::Float, .faceBorder = target.faceBorder});
}

} // namespace

void addConvertCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("convert", "Resample a probe to another parameterization, size or yaw");
    command->add_option("PROBE", o->probe, "file or builtin:NAME")->required();
    command->add_option("-o,--output", o->out, "output file; %s in the name of a cube makes six files, of a paraboloid two, %d one file a level")->required();
    command->add_option("--to", o->to, "parameterization of the output (KIND)")->required();
    command->add_option("--size", o->size, "face edge, disc edge, latlong height or octahedral edge, in texels")->required();
    o->reading.addTo(*command);
    command->add_option("--yaw", o->yawDeg, "turn the environment about +Y, counterclockwise from above, in degrees");
    command->add_option("--border", o->border, "texels kept free outside each disc of a paraboloid map; around each cube face, its neighbors' texels");
    command->add_flag("--mips", o->mips, "add the mip levels, filtered across seams");
    command->add_flag("--half", o->half, "16-bit floats (.exr, .tif)");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(CLI::Range(0, 1024));
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
