#include "export_format.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <filesystem>

namespace mirrorball::studio {

namespace {

QString extensionOf(const ExportTarget& target)
{
    return QString::fromStdString(std::filesystem::path(target.fileName()).extension().string()).toLower();
}

/// An empty file name says the same as the default one, in fewer words.
void setFile(ExportTarget& target, const std::string& file)
{
    target.file = file == target.name + ".exr" ? std::string() : file;
}

} // namespace

const std::vector<ExportFormat>& exportFormats()
{
    const auto text = [](const char* source) { return QCoreApplication::translate("ExportFormat", source); };
    static const std::vector<ExportFormat> formats{
        {text("OpenEXR, 32-bit float"), QStringLiteral(".exr"), false, true}, {text("OpenEXR, 16-bit half"), QStringLiteral(".exr"), true, true},
        {text("Radiance HDR"), QStringLiteral(".hdr"), false, false},         {text("TIFF, 32-bit float"), QStringLiteral(".tif"), false, true},
        {text("TIFF, 16-bit half"), QStringLiteral(".tif"), true, true},      {text("PNG, tone-mapped 8 bit"), QStringLiteral(".png"), false, false}};
    return formats;
}

int formatOf(const ExportTarget& target)
{
    const QString extension = extensionOf(target);
    const std::vector<ExportFormat>& formats = exportFormats();
    const auto matches = [&](const ExportFormat& f) { return f.extension == extension && f.half == (target.half && f.holdsLevels); };
    const auto found = std::find_if(formats.begin(), formats.end(), matches);
    return found == formats.end() ? -1 : static_cast<int>(found - formats.begin());
}

ExportTarget withFormat(ExportTarget target, const ExportFormat& format)
{
    std::filesystem::path file = target.fileName();
    file.replace_extension(format.extension.toStdString());
    setFile(target, file.string());
    target.half = format.half;
    target.mips = target.mips && format.holdsLevels;
    return target;
}

bool hasFaceFiles(const ExportTarget& target)
{
    return target.fileName().find("%s") != std::string::npos;
}

ExportTarget withCubeFiles(ExportTarget target, CubeFiles files)
{
    if (hasFaceFiles(target) == (files == CubeFiles::Six))
        return target;
    const std::filesystem::path file = target.fileName();
    std::string stem = file.stem().string();
    if (files == CubeFiles::Six) {
        stem += "_%s";
    } else {
        const size_t mark = stem.find("%s");
        const bool hasSeparator = mark > 0 && (stem[mark - 1] == '_' || stem[mark - 1] == '-');
        stem.erase(hasSeparator ? mark - 1 : mark, hasSeparator ? 3 : 2);
        if (stem.empty())
            stem = target.name;
    }
    setFile(target, (file.parent_path() / (stem + file.extension().string())).string());
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
