#include "command.h"
#include "frames.h"
#include "reading_options.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/image_format.h"
#include "core/preview/picture_file.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_maps.h"
#include "core/scene/scene_words.h"
#include "core/shading/brdf_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace mirrorball::cli {

namespace {

/// An option that sets one field of the scene as a file would. Its help and range are the field's.
struct FieldOption {
    const char* flag;
    const char* field;
    /// A second field that the option implies, and its value: an exponent makes the lobe phong.
    const char* impliedField = nullptr;
    const char* impliedValue = nullptr;
};

constexpr std::array fieldOptions{
    FieldOption{"--yaw", "probe.yaw"},
    FieldOption{"--probe-exposure", "probe.exposure"},
    FieldOption{"--from", "probe.parameterization"},
    FieldOption{"--part", "probe.part"},
    FieldOption{"--layer", "probe.layer"},
    FieldOption{"--window", "probe.window"},
    FieldOption{"--color-space", "probe.color_space"},
    FieldOption{"--fit", "probe.fit"},
    FieldOption{"--horizontal-angle", "probe.horizontal_angle"},
    FieldOption{"--vertical-angle", "probe.vertical_angle"},
    FieldOption{"--beyond", "probe.beyond"},
    FieldOption{"--faces", "probe.faces"},
    FieldOption{"--mirror", "probe.mirror"},
    FieldOption{"--rotate", "probe.rotate"},
    FieldOption{"--kind", "map.parameterization"},
    FieldOption{"--map-size", "map.size"},
    FieldOption{"--border", "map.border"},
    FieldOption{"--mips", "map.mips"},
    FieldOption{"--exponent", "material.specular.exponent", "material.specular.lobe", "phong"},
    FieldOption{"--roughness", "material.specular.roughness", "material.specular.lobe", "ggx"},
    FieldOption{"--ior", "material.fresnel.index", "material.fresnel.kind", "dielectric"},
    FieldOption{"--metal", "material.fresnel.metal", "material.fresnel.kind", "conductor"},
    FieldOption{"--brdf", "material.brdf.model"},
    FieldOption{"--lookups", "material.brdf.lookups"},
    FieldOption{"--combine", "material.combine"},
    FieldOption{"--lambda", "material.lambda"},
    FieldOption{"--lambda-grazing", "material.lambda_grazing"},
    FieldOption{"--mip-filtering", "map.mip_filtering"},
    FieldOption{"--lod-bias", "material.lod_bias"},
    FieldOption{"--fov", "view.camera.fov"},
    FieldOption{"--projection", "view.camera.projection"},
    FieldOption{"--shading", "view.shading"},
    FieldOption{"--exposure", "view.exposure"},
    FieldOption{"--tone", "view.tone"},
    FieldOption{"--background", "view.background.kind"},
    FieldOption{"--sphere-map", "material.sphere_map.source"},
    FieldOption{"--use", "material.sphere_map.use"},
};

struct Options {
    std::string scene, probe, material, geometry, size, camera, out, saved, stats, frames;
    std::map<std::string, std::string> fields; ///< by flag, as typed
    std::vector<std::string> set;
    int threads = 0;
    bool explain = false;
};

/// "material.specular.exponent: must be ..." becomes "--exponent: must be ...".
void setByOption(Scene& scene, const std::string& option, const std::string& field, const std::string& value)
{
    try {
        setField(scene, field, value);
    } catch (const InvalidArgument& error) {
        std::string message = error.what();
        if (message.starts_with(field))
            message = message.substr(message.find(": ") + 2);
        throw InvalidArgument(option + ": " + message);
    }
}

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

void setSize(Scene& scene, const std::string& text)
{
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() != 2)
        throw InvalidArgument("--size: must be WIDTHxHEIGHT in pixels, such as 1280x720; it is '" + text + "'");
    setByOption(scene, "--size", "view.width", parts[0]);
    setByOption(scene, "--size", "view.height", parts[1]);
}

void setCamera(Scene& scene, const std::string& text)
{
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() < 2 || parts.size() > 3)
        throw InvalidArgument("--camera: must be YAW,PITCH or YAW,PITCH,DISTANCE, such as 25,18,3.4; it is '" + text + "'");
    constexpr std::array fields{"view.camera.yaw", "view.camera.pitch", "view.camera.distance"};
    for (size_t i = 0; i < parts.size(); ++i)
        setByOption(scene, "--camera", fields[i], parts[i]);
}

void setGeometry(Scene& scene, const std::string& word)
{
    if (!isBuiltinGeometry(word) && word.find_first_of("./\\") == std::string::npos)
        throw InvalidArgument("--geometry: '" + word + "' is neither teapot, torus, sphere, box or window nor a mesh file");
    scene.view.geometry = isBuiltinGeometry(word) ? word : std::filesystem::absolute(word).string();
}

/// The scene that the file and the options make together.
Scene makeScene(const Options& o)
{
    Scene scene = o.scene.empty() ? Scene{} : loadScene(o.scene);
    if (!o.probe.empty())
        scene.probe = {.source = probeFromWord(o.probe)};
    if (!o.material.empty())
        scene.material = materialFromWord("--material", o.material);
    if (!o.geometry.empty())
        setGeometry(scene, o.geometry);
    if (!o.size.empty())
        setSize(scene, o.size);
    if (!o.camera.empty())
        setCamera(scene, o.camera);
    for (const FieldOption& option : fieldOptions)
        if (const auto given = o.fields.find(option.flag); given != o.fields.end() && !given->second.empty()) {
            const std::string_view flag = option.flag;
            const bool isFile =
                (flag == "--sphere-map" && isSphereMapFile(given->second)) || (flag == "--brdf" && isBrdfFile(given->second));
            if (flag == "--rotate") {
                scene.probe.reading.rotateDeg = parseRotation(option.flag, given->second);
                continue;
            }
            setByOption(scene, option.flag, option.field, isFile ? std::filesystem::absolute(given->second).string() : given->second);
            if (option.impliedField)
                setField(scene, option.impliedField, option.impliedValue);
        }
    for (const std::string& assignment : o.set) {
        const size_t equals = assignment.find('=');
        if (equals == std::string::npos)
            throw InvalidArgument("--set: must be FIELD=VALUE, such as material.lambda=2; it is '" + assignment + "'");
        setByOption(scene, "--set " + assignment.substr(0, equals), assignment.substr(0, equals), assignment.substr(equals + 1));
    }
    return scene;
}

void runOne(const Options& o, const JobControl& job)
{
    writableFormat(o.out);
    checkTarget(o.out);
    checkOutputsDiffer({{"--output", {o.out}}, {"--save-scene", filesOf(o.saved)}, {"--stats", filesOf(o.stats)}});
    const Scene scene = makeScene(o);
    PlannedScene planned = planScene(scene);
    const std::vector<Stage> plan = planned.plan.stages;
    if (o.explain)
        printStages(plan);
    const WorkRecord record = preview::savePicture(std::move(planned), o.out, job);
    printNotes(scene.probe.source, record.notes);
    sayUnpromised("render", record);
    if (!o.saved.empty())
        saveScene(scene, o.saved);
    if (!o.stats.empty())
        writeStats(o.stats, plan, record, job.threadCount());
}

void run(const Options& o)
{
    if (o.frames.empty()) {
        runOne(o, jobWithProgress("render", o.threads));
        return;
    }
    forFrames(o.frames, {o.out, o.saved, o.stats}, o.threads, FramesAtOnce::One, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.scene, &one.probe, &one.material, &one.geometry, &one.out, &one.saved, &one.stats})
            *name = withFrame(*name, frame);
        for (auto& [flag, value] : one.fields)
            value = withFrame(value, frame);
        for (std::string& assignment : one.set)
            assignment = withFrame(assignment, frame);
        runOne(one, job);
    });
}

/// The name that an option's value has in the help: its words or its range.
std::string valueHelp(const FieldEntry& entry)
{
    std::string help(entry.field.help);
    std::string words;
    for (const std::string_view word : entry.words)
        words += (words.empty() ? "" : " | ") + std::string(word);
    if (!words.empty())
        help += ": " + words;
    if (!entry.field.unit.empty())
        help += " (" + std::string(entry.field.unit) + ")";
    return help;
}

} // namespace

void addRenderCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("render", "Render a picture of a material under a probe");
    command->add_option("SCENE", o->scene, "scene file (.mirrorball); options override what it says");
    command->add_option("-o,--output", o->out, "picture: .png (tone-mapped, sRGB) or .exr (linear radiance)")->required();
    command->add_option("--probe", o->probe, "image file, or builtin:NAME");
    command->add_option("--material", o->material, "preset (see mirrorball presets) or material file");
    command->add_option("--geometry", o->geometry, "teapot, torus, sphere, box, window, or a mesh file (.obj .ply .stl .gltf ...)");
    command->add_option("--size", o->size, "WIDTHxHEIGHT in pixels");
    command->add_option("--camera", o->camera, "YAW,PITCH[,DISTANCE]: degrees; the object's radius is 1");
    const std::vector<FieldEntry> entries = sceneFields();
    for (const FieldOption& option : fieldOptions) {
        const auto entry = std::find_if(entries.begin(), entries.end(), [&](const FieldEntry& e) { return e.path == option.field; });
        command->add_option(option.flag, o->fields[option.flag], valueHelp(*entry));
    }
    command->add_option("--set", o->set, "FIELD=VALUE: any field of the scene file, such as view.background.blur=0.5")
        ->allow_extra_args(false);
    command->add_option("--save-scene", o->saved, "write the scene that was drawn, options and all, to this .mirrorball file");
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
