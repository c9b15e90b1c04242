#include "command.h"
#include "frames.h"
#include "reading_options.h"
#include "variants.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/image_format.h"
#include "core/image/picture_grid.h"
#include "core/preview/picture_file.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_maps.h"
#include "core/scene/scene_words.h"
#include "core/shading/brdf_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

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
    FieldOption{"--lookups", "material.brdf.lookups", "material.brdf.kind", "fitted"},
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
    std::string scene, probe, material, geometry, size, camera, out, saved, stats, frames, turn;
    std::map<std::string, std::string> fields; ///< by flag, as typed
    std::vector<std::string> set, grid;
    int turntable = 0;
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
    const bool isBuiltin = builtinGeometry(word).has_value();
    if (!isBuiltin && word.find_first_of("./\\") == std::string::npos)
        throw InvalidArgument("--geometry: '" + word + "' is neither teapot, torus, sphere, box or window nor a mesh file");
    scene.view.geometry = isBuiltin ? word : std::filesystem::absolute(word).string();
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
            if (flag == "--lookups" && given->second == wordOf(LookupKind::Exact)) {
                scene.material.brdf.kind = LookupKind::Exact;
                continue;
            }
            if (const auto choice = lookupChoiceFromWord(given->second);
                flag == "--lookups" && choice && choice->kind != LookupKind::Fitted) {
                scene.material.brdf.kind = choice->kind;
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

void printAll(const Options& o, const Scene& scene, const std::vector<Stage>& plan, const WorkRecord& record, const JobControl& job)
{
    printNotes(scene.probe.source, record.notes);
    sayUnpromised("render", record);
    if (!o.saved.empty())
        saveScene(scene, o.saved);
    if (!o.stats.empty())
        writeStats(o.stats, plan, record, job.threadCount());
}

void drawPicture(const Options& o, const Scene& scene, preview::PictureMaker& maker, const JobControl& job)
{
    PlannedScene planned = planScene(scene);
    const std::vector<Stage> plan = planned.plan.stages();
    if (o.explain)
        printStages(plan);
    const WorkRecord record = preview::savePicture(maker, std::move(planned), o.out, job);
    printAll(o, scene, plan, record, job);
}

/// The scenes of a grid's cells, row by row, and the grid. @throws InvalidArgument before anything is read or drawn
std::pair<std::vector<Scene>, PictureGrid> gridOf(const Options& o, const Scene& scene)
{
    const std::vector<GridAxis> axes = parseGrid(o.grid);
    const GridAxis columns = axes[0], rows = axes.size() > 1 ? axes[1] : GridAxis{.values = {""}};
    PictureGrid grid;
    std::vector<Scene> cells;
    for (size_t row = 0; row < rows.values.size(); ++row) {
        if (!rows.field.empty())
            grid.rows.push_back(rows.label(row));
        for (size_t column = 0; column < columns.values.size(); ++column) {
            if (row == 0)
                grid.columns.push_back(columns.label(column));
            cells.push_back(scene);
            setByOption(cells.back(), "--grid " + columns.field, columns.field, columns.values[column]);
            if (!rows.field.empty())
                setByOption(cells.back(), "--grid " + rows.field, rows.field, rows.values[row]);
            const ViewSettings &view = cells.back().view, &first = cells.front().view;
            if (view.width != first.width || view.height != first.height)
                throw InvalidArgument("--grid: its pictures are all of one size; give --size in place of view.width and view.height");
        }
    }
    grid.cellWidth = cells.front().view.width;
    grid.cellHeight = cells.front().view.height;
    constexpr std::int64_t longest = 16384, most = std::int64_t{1} << 27;
    if (const GridSize size = sizeOf(grid); size.width > longest || size.height > longest || size.width * size.height > most)
        throw InvalidArgument("--grid: the picture would have " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                              " pixels, at most 16384 along a side and 134 million together; give a smaller --size or fewer values");
    return {std::move(cells), std::move(grid)};
}

void drawGrid(const Options& o, const Scene& scene, preview::PictureMaker& maker, const JobControl& job)
{
    const auto [cells, grid] = gridOf(o, scene);
    std::vector<Stage> plan;
    for (const Scene& cell : cells) { // what is wrong with one is said before any is drawn
        const PlannedScene planned = planScene(cell);
        const std::vector<Stage> stages = planned.plan.stages();
        plan.insert(plan.end(), stages.begin(), stages.end());
        if (o.explain)
            printStages(stages);
    }
    WorkRecord record;
    bool hasOpacity = false, isOnePicture = true;
    Image before;
    const size_t columns = grid.columns.size();
    Image picture = layOut(grid, [&](int row, int column) {
        const size_t index = static_cast<size_t>(row) * columns + static_cast<size_t>(column);
        const float count = static_cast<float>(cells.size());
        preview::Picture drawn = maker.draw(planScene(cells[index]), preview::lightOf(o.out),
                                            partOf(job, static_cast<float>(index) / count, static_cast<float>(index + 1) / count));
        record += std::move(drawn.record);
        hasOpacity = hasOpacity || cells[index].view.background.kind == Backdrop::None;
        isOnePicture = isOnePicture && (index == 0 || drawn.image == before);
        before = drawn.image;
        return std::move(drawn.image);
    });
    timedStage(record.stages, "save picture",
               [&] { preview::writePicture(o.out, std::move(picture), hasOpacity ? Backdrop::None : Backdrop::Environment); });
    for (std::vector<std::string>* lines : {&record.notes, &record.unpromised}) { // a note on the probe comes with every cell
        std::sort(lines->begin(), lines->end());
        lines->erase(std::unique(lines->begin(), lines->end()), lines->end());
    }
    printAll(o, scene, plan, record, job);
    if (isOnePicture && cells.size() > 1)
        std::fprintf(stderr,
                     "mirrorball: render: --grid: all pictures are the same; a field may need another, as material.specular.roughness "
                     "needs --set material.specular.lobe=ggx\n");
}

void runOne(const Options& o, const Scene& scene, preview::PictureMaker& maker, const JobControl& job)
{
    if (o.grid.empty())
        drawPicture(o, scene, maker, job);
    else
        drawGrid(o, scene, maker, job);
}

void checkOutputs(const Options& o)
{
    writableFormat(o.out);
    checkTarget(o.out);
    checkOutputsDiffer({{"--output", {o.out}}, {"--save-scene", filesOf(o.saved)}, {"--stats", filesOf(o.stats)}});
    if (!o.grid.empty() && !o.saved.empty())
        throw InvalidArgument("--save-scene: a --grid draws a scene for every cell; leave out one of the two");
}

void run(const Options& o)
{
    preview::PictureMaker maker;
    if (o.turntable == 0 && !o.turn.empty())
        throw InvalidArgument("--turn: says what a turntable turns; give --turntable N, too");
    if (o.turntable > 0) {
        if (!o.frames.empty())
            throw InvalidArgument("--turntable: its frames are those of one turn; leave out --frames");
        forFrames("--turntable", {1, o.turntable}, {o.out, o.saved, o.stats}, o.threads, FramesAtOnce::One,
                  [&](int frame, const JobControl& job) {
                      Options one = o;
                      for (std::string* name : {&one.out, &one.saved, &one.stats})
                          *name = withFrame(*name, frame);
                      checkOutputs(one);
                      runOne(one, turned(makeScene(one), o.turn == "environment" ? Turns::Environment : Turns::Camera, frame, o.turntable),
                             maker, job);
                  });
        return;
    }
    if (o.frames.empty()) {
        checkOutputs(o);
        runOne(o, makeScene(o), maker, jobWithProgress("render", o.threads));
        return;
    }
    forFrames(o.frames, {o.out, o.saved, o.stats}, o.threads, FramesAtOnce::One, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.scene, &one.probe, &one.material, &one.geometry, &one.out, &one.saved, &one.stats})
            *name = withFrame(*name, frame);
        for (auto& [flag, value] : one.fields)
            value = withFrame(value, frame);
        for (std::vector<std::string>* texts : {&one.set, &one.grid})
            for (std::string& assignment : *texts)
                assignment = withFrame(assignment, frame);
        checkOutputs(one);
        runOne(one, makeScene(one), maker, job);
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
    command
        ->add_option("--set", o->set,
                     "FIELD=VALUE: any field of the scene file, such as view.background.blur=0.5; colors and points as "
                     "[1,0.5,0.2], in quotes where the shell reads brackets")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--grid", o->grid,
            "FIELD=VALUE,VALUE: a picture for each value, side by side in one; given twice, columns and rows. Values as --set takes "
            "them, between semicolons where one has a comma: 'material.diffuse.color=[1,0,0];[0,0,1]'")
        ->allow_extra_args(false);
    command
        ->add_option("--turntable", o->turntable,
                     "make this many frames of a full turn, numbered from 1; #### in names stands for the frame's number")
        ->check(within(1, 100000));
    command->add_option("--turn", o->turn, "what a turntable turns: camera, as without it, or environment")
        ->check(CLI::IsMember({"camera", "environment"}));
    command->add_option("--save-scene", o->saved, "write the scene that was drawn, options and all, to this .mirrorball file");
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
