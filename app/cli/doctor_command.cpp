#include "command.h"

#include "core/doctor/diagnosis.h"
#include "core/image/map_file.h"

#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string map, probe, from;
    int threads = 1; ///< the work is a second of one core; more of them would mostly wait for each other
    bool json = false;
};

void run(const Options& o)
{
    const JobControl job = jobWithProgress("doctor", o.threads);
    const std::optional<Parameterization> from = o.from.empty() ? std::optional<Parameterization>{} : parseKind("--from", o.from);
    const StoredMap map = readStoredMap(o.map, from, job);
    std::optional<EnvironmentMap> probe;
    if (!o.probe.empty())
        probe = readProbe(o.probe, {}, job).map;
    Diagnosis diagnosis = diagnose(map, probe, {}, job);
    diagnosis.map = o.map;
    diagnosis.probe = o.probe;
    std::fputs((o.json ? diagnosisJson(diagnosis) : diagnosisText(diagnosis)).c_str(), stdout);
}

} // namespace

void addDoctorCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "doctor",
        "Tell what a prefiltered map of anyone is: orientation, roughness law, lobe, scale, the error of every level, its faults");
    command
        ->add_option("MAP", o->map,
                     "a .ktx, .ktx2, .dds or .env file, an image with levels, or a name with %s for a face (px nx py ny pz nz) and %d for "
                     "a level")
        ->required();
    command->add_option("--probe", o->probe, "what the map was made from: file or builtin:NAME; without it only what the levels tell");
    command->add_option("--from", o->from, "parameterization of MAP, where its shape does not tell (KIND)");
    command->add_option("--threads", o->threads, "0: all cores")->check(CLI::Range(0, 1024));
    command->add_flag("--json", o->json, "as JSON");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
