#include "command.h"
#include "engine_words.h"
#include "frames.h"
#include "reading_options.h"

#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/probe_resampling.h"

#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, to, engine, encode, frames, resample = "linear";
    ReadingOptions reading;
    int size = 0, border = 0, threads = 0;
    double yawDeg = 0.0;
    bool mips = false, half = false;
};

void runOne(const Options& o, const JobControl& job)
{
    const MapTarget target = parseTarget(o.to, o.size, o.border);
    checkMapFile(o.out, target.layout);
    const EngineTurn turn = engineTurn(o.engine, target.layout.kind);
    const WriteOptions write{.sampleType = o.half ? SampleType::Half : SampleType::Float,
                             .bytes = parseEncode(o.encode, o.out),
                             .faceBorder = target.faceBorder};
    ReadProbeOptions read{.reading = o.reading.parse()};
    const glm::dmat3 orient = orientation(read.reading); // left to the resampling, which happens only once then
    read.reading.mirror = MirrorAxis::None;
    read.reading.rotateDeg = glm::dvec3(0.0);
    std::vector<MapLayout> layouts;
    for (int i = 0; i < (o.mips ? levelCount(target.layout) : 1); ++i)
        layouts.push_back(levelLayout(target.layout, i));
    checkOutputsDiffer({{"--output", mapFiles(o.out, layouts, target.faceBorder)}});
    const ReprojectOptions options{.target = target.layout,
                                   .yaw = radians(o.yawDeg + turn.yawDeg),
                                   .turn = orient,
                                   .resample = o.resample == "cubic" ? Resample::Cubic : Resample::Linear};
    Probe probe = readResampled(ProbeFile(o.probe, read), options, o.mips ? partOf(job, 0.0f, 0.8f) : job);
    printNotes(o.probe, probe.notes);
    EnvironmentMap map = std::move(probe.map);
    std::vector<EnvironmentMap> levels;
    if (o.mips)
        levels = buildMipPyramid(map, partOf(job, 0.8f, 1.0f)).levels;
    else
        levels.push_back(std::move(map));
    store(levels, turn.orientation);
    writeMap(o.out, levels, write);
}

void run(const Options& o)
{
    if (o.frames.empty()) {
        runOne(o, jobWithProgress("convert", o.threads));
        return;
    }
    forFrames(o.frames, {o.out}, o.threads, FramesAtOnce::PerCore, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.probe, &one.out})
            *name = withFrame(*name, frame);
        runOne(one, job);
    });
}

} // namespace

void addConvertCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("convert", "Resample a probe to another parameterization, size or yaw");
    command->add_option("PROBE", o->probe, "file or builtin:NAME")->required();
    command->add_option("-o,--output", o->out, outputHelp)->required();
    command->add_option("--to", o->to, "parameterization of the output (KIND)")->required();
    command->add_option("--size", o->size, "face edge, disc edge, latlong height or octahedral edge, in texels")
        ->check(anEdge())
        ->required();
    o->reading.addTo(*command);
    command->add_option("--yaw", o->yawDeg, "turn the environment about +Y, counterclockwise from above, in degrees")->check(anAngle());
    command->add_option("--resample", o->resample, "between texels where the output is finer than the probe: linear or cubic")
        ->check(CLI::IsMember({"linear", "cubic"}));
    command->add_option("--border", o->border, borderHelp)->check(within(0, 4096));
    command->add_flag("--mips", o->mips, "add the mip levels, filtered across seams");
    command->add_flag("--half", o->half, "16-bit floats, where the format has them");
    command->add_option("--for", o->engine, "turn and mirror the map as this engine looks it up (latlong or cube)");
    command->add_option("--encode", o->encode, "of 8-bit formats: filmic (as without it), srgb, or in a .png rgbe, rgbm, rgbd, rgbp");
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
