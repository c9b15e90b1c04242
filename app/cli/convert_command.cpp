#include "command.h"
#include "engine_words.h"

#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/probe_file.h"
#include "core/image/reproject.h"

#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, to, from, engine, encode;
    int size = 0, border = 0, threads = 0;
    double yawDeg = 0.0;
    bool mips = false, half = false;
};

void run(const Options& o)
{
    const MapLayout target{.kind = parseKind("--to", o.to), .size = o.size, .border = o.border};
    validate(target);
    checkMapFile(o.out, target);
    const EngineTurn turn = engineTurn(o.engine, target.kind);
    const WriteOptions write{.sampleType = o.half ? SampleType::Half : SampleType::Float, .bytes = parseEncode(o.encode, o.out)};
    ReadProbeOptions read;
    if (!o.from.empty())
        read.from = parseKind("--from", o.from);
    std::vector<MapLayout> layouts;
    for (int i = 0; i < (o.mips ? levelCount(target) : 1); ++i)
        layouts.push_back(levelLayout(target, i));
    checkOutputsDiffer({{"--output", mapFiles(o.out, layouts)}});
    const JobControl job = jobWithProgress("convert", o.threads);
    const Probe probe = readProbe(o.probe, read, partOf(job, 0.0f, 0.4f));
    EnvironmentMap map =
        reproject(probe.map, {.target = target, .yaw = radians(o.yawDeg + turn.yawDeg)}, partOf(job, 0.4f, o.mips ? 0.8f : 1.0f));
    std::vector<EnvironmentMap> levels;
    if (o.mips)
        levels = buildMipPyramid(map, partOf(job, 0.8f, 1.0f)).levels;
    else
        levels.push_back(std::move(map));
    store(levels, turn.orientation);
    writeMap(o.out, levels, write);
}

} // namespace

void addConvertCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("convert", "Resample a probe to another parameterization, size or yaw");
    command->add_option("PROBE", o->probe, "file or builtin:NAME")->required();
    command->add_option("-o,--output", o->out, "output file; %s in the name of a cube makes six files, %d one file a level")->required();
    command->add_option("--to", o->to, "parameterization of the output (KIND)")->required();
    command->add_option("--size", o->size, "face edge, disc edge, latlong height or octahedral edge, in texels")
        ->check(anEdge())
        ->required();
    command->add_option("--from", o->from, "parameterization of the input, where it is not to be found out (KIND)");
    command->add_option("--yaw", o->yawDeg, "turn the environment about +Y, counterclockwise from above, in degrees")->check(anAngle());
    command->add_option("--border", o->border, "texels kept free outside each disc of a paraboloid map")->check(within(0, 4096));
    command->add_flag("--mips", o->mips, "add the mip levels, filtered across seams");
    command->add_flag("--half", o->half, "16-bit floats, where the format has them");
    command->add_option("--for", o->engine, "turn and mirror the map as this engine looks it up (latlong or cube)");
    command->add_option("--encode", o->encode, "of 8-bit formats: filmic (as without it), srgb, or in a .png rgbe, rgbm, rgbd, rgbp");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
