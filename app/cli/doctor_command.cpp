#include "command.h"
#include "reading_options.h"

#include "core/base/error.h"
#include "core/doctor/diagnosis.h"
#include "core/image/map_file.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string map, probe, from, encode;
    ReadingOptions reading;
    int threads = 1; ///< the work is a second of one core; more of them would mostly wait for each other
    bool json = false;
};

std::optional<PackedColor> packedForm(const std::string& word)
{
    const auto forms = words(PackedColor{});
    const auto found = std::find(forms.begin(), forms.end(), word);
    if (found != forms.end())
        return static_cast<PackedColor>(found - forms.begin());
    if (!word.empty())
        throw InvalidArgument("--encode: '" + word + "' is none; choose rgbe, rgbm, rgbd or rgbp, or leave it out");
    return {};
}

void run(const Options& o)
{
    const JobControl job = jobWithProgress("doctor", o.threads);
    StoredMapReading stored{.packed = packedForm(o.encode)};
    if (!o.from.empty())
        stored.from = parseKind("--from", o.from);
    const StoredMap map = readStoredMap(o.map, stored, job);
    std::optional<EnvironmentMap> probe;
    if (!o.probe.empty()) {
        const Probe read = readProbe(o.probe, {.reading = o.reading.parse()}, job);
        printNotes(o.probe, read.notes);
        probe = read.map;
    }
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
    o->reading.addTo(*command, "--from"); // which is of MAP here
    command->add_option("--from", o->from, "parameterization of MAP, where its shape does not tell (KIND)");
    command->add_option(
        "--encode", o->encode,
        "how the texels of 8-bit .png pictures hold radiance: rgbe, rgbm, rgbd or rgbp; one of 512 x 512 in rgbm or rgbp is "
        "PlayCanvas' atlas");
    command->add_option("--threads", o->threads, "0: all cores")->check(CLI::Range(0, 1024));
    command->add_flag("--json", o->json, "as JSON");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
