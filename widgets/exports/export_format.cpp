#include "export_format.h"

#include "widgets/controls/text.h"

#include "core/image/image_format.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <QCoreApplication>

#include <algorithm>
#include <filesystem>

namespace mirrorball::studio {

namespace {

/// An empty file name says the same as the default one, in fewer words.
void setFile(ExportTarget& target, const std::string& file) { target.file = file == target.name + ".exr" ? std::string() : file; }

bool hasMark(const ExportTarget& target, std::string_view mark) { return target.fileName().find(mark) != std::string::npos; }

void setStem(ExportTarget& target, const std::string& stem)
{
    const std::filesystem::path file = target.fileName();
    setFile(target, (file.parent_path() / (stem + file.extension().string())).string());
}

ExportTarget withMark(ExportTarget target, const std::string& mark)
{
    if (!hasMark(target, mark))
        setStem(target, std::filesystem::path(target.fileName()).stem().string() + "_" + mark);
    return target;
}

/// The mark leaves the file name together with what divides it from the rest.
ExportTarget withoutMark(ExportTarget target, const std::string& mark)
{
    std::string stem = std::filesystem::path(target.fileName()).stem().string();
    const size_t at = stem.find(mark);
    if (at == std::string::npos)
        return target;
    const bool hasSeparator = at > 0 && (stem[at - 1] == '_' || stem[at - 1] == '-');
    stem.erase(hasSeparator ? at - 1 : at, mark.size() + (hasSeparator ? 1 : 0));
    setStem(target, stem.empty() ? target.name : stem);
    return target;
}

/// "OpenEXR, 16-bit half": where a format has two sample types, which one.
QString formatWords(const ImageFormat& format, bool half)
{
    const QString label = toQString(format.label);
    if (!format.half)
        return label;
    return half ? QCoreApplication::translate("ExportFormat", "%1, 16-bit half").arg(label)
                : QCoreApplication::translate("ExportFormat", "%1, 32-bit float").arg(label);
}

} // namespace

const std::vector<ExportFormat>& exportFormats()
{
    static const std::vector<ExportFormat> formats = [] {
        std::vector<ExportFormat> all;
        for (const ImageFormat& format : imageFormats())
            if (format.write)
                for (const bool half : format.half ? std::vector{false, true} : std::vector{false})
                    all.push_back({formatWords(format, half), toQString(format.extensions.front()), half, format.levels,
                                   format.samples == StoredSamples::Byte});
        return all;
    }();
    return formats;
}

int formatOf(const ExportTarget& target)
{
    const ImageFormat* const format = findFormat(target.fileName());
    if (!format)
        return -1;
    const QString extension = toQString(format->extensions.front());
    const std::vector<ExportFormat>& formats = exportFormats();
    const auto matches = [&](const ExportFormat& f) { return f.extension == extension && f.half == (target.half && format->half); };
    const auto found = std::find_if(formats.begin(), formats.end(), matches);
    return found == formats.end() ? -1 : static_cast<int>(found - formats.begin());
}

ExportTarget withFormat(ExportTarget target, const ExportFormat& format)
{
    std::filesystem::path file = target.fileName();
    file.replace_extension(format.extension.toStdString());
    setFile(target, file.string());
    target.half = format.half;
    return withMips(target, target.mips && canHaveMips(target) ? Mips::All : Mips::None);
}

QString formatText(const ExportFormat& format, ExportKind kind)
{
    if (!format.isShown)
        return format.text;
    return kind == ExportKind::Painted ? QCoreApplication::translate("ExportFormat", "%1, 8 bit").arg(format.text)
                                       : QCoreApplication::translate("ExportFormat", "%1, tone-mapped 8 bit").arg(format.text);
}

bool hasFaceFiles(const ExportTarget& target) { return hasMark(target, "%s"); }

ExportTarget withCubeFiles(ExportTarget target, CubeFiles files)
{
    return files == CubeFiles::Six ? withMark(target, "%s") : withoutMark(target, "%s");
}

bool hasLevelFiles(const ExportTarget& target) { return hasMark(target, "%d"); }

ExportTarget withLevelFiles(ExportTarget target, LevelFiles files)
{
    return files == LevelFiles::Each ? withMark(target, "%d") : withoutMark(target, "%d");
}

bool canHaveMips(const ExportTarget& target)
{
    return target.kind == ExportKind::Painted || holdsMips(target.fileName()) || hasLevelFiles(target);
}

ExportTarget withMips(ExportTarget target, Mips mips)
{
    target.mips = mips == Mips::All;
    if (target.mips && target.kind == ExportKind::Painted)
        target.border = 0;
    return target.mips || target.kind == ExportKind::Chain ? target : withLevelFiles(target, LevelFiles::One);
}

ExportTarget withKind(ExportTarget target, ExportKind kind)
{
    target.kind = kind;
    if (kind != ExportKind::Chain)
        target.levels = 0;
    if (kind == ExportKind::Painted) {
        target.size = std::min(target.size, largestSphereMap);
        target.border = std::min(target.border, (target.size - 1) / 2);
        target = withCubeFiles(target, CubeFiles::One);
    } else if (!mapping(target.parameterization).hasBorder) {
        target.border = 0;
    }
    return withMips(target, target.mips && kind != ExportKind::Chain && canHaveMips(target) ? Mips::All : Mips::None);
}

ExportTarget newTarget(const Scene& scene, ExportKind kind)
{
    const SphereMapSettings& painted = scene.material.sphereMap;
    if (kind == ExportKind::Painted) {
        ExportTarget target{.name = freeName(scene.exports, "matcap"), .kind = kind, .size = painted.size};
        const SphereMapPreset* preset = painted.document ? nullptr : findSphereMapPreset(painted.source);
        const SphereMapDocument* map = painted.document ? painted.document.document.get() : preset ? &preset->document : nullptr;
        target.mips = map && hasAuthoredLevels(*map) && painted.levels == SphereMapLevels::Authored;
        target.file = target.mips ? std::string() : target.name + ".png";
        return target;
    }
    ExportTarget target{.name = freeName(scene.exports, std::string(wordOf(kind))), .kind = kind};
    target.parameterization = scene.map.parameterization;
    target.size = kind == ExportKind::Diffuse ? 64 : scene.map.size;
    target.border = std::min(scene.map.border, (target.size - 1) / 2);
    return target;
}

std::string freeName(const std::vector<ExportTarget>& targets, const std::string& wanted)
{
    const auto isTaken = [&](const std::string& name) {
        return std::any_of(targets.begin(), targets.end(), [&](const ExportTarget& t) { return t.name == name; });
    };
    std::string name = wanted;
    for (int i = 2; isTaken(name); ++i)
        name = wanted + "-" + std::to_string(i);
    return name;
}

} // namespace mirrorball::studio
