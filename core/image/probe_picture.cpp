#include "probe_picture.h"

#include "environment_map.h"
#include "file_names.h"
#include "paraboloid_halves.h"

#include "core/base/error.h"

#include <algorithm>
#include <cctype>

namespace mirrorball {

namespace {

using Words = std::array<std::string_view, 6>;

constexpr std::array<Words, 11> faceWords{{{"px", "nx", "py", "ny", "pz", "nz"},
                                           {"posx", "negx", "posy", "negy", "posz", "negz"},
                                           {"+x", "-x", "+y", "-y", "+z", "-z"},
                                           {"x+", "x-", "y+", "y-", "z+", "z-"},
                                           {"xpos", "xneg", "ypos", "yneg", "zpos", "zneg"},
                                           {"right", "left", "top", "bottom", "front", "back"},
                                           {"right", "left", "up", "down", "front", "back"},
                                           {"rt", "lf", "up", "dn", "ft", "bk"},
                                           {"r", "l", "u", "d", "f", "b"},
                                           {"0", "1", "2", "3", "4", "5"},
                                           {"1", "2", "3", "4", "5", "6"}}};

constexpr int spellings = 5;

/// A word as people spell it: as it is, in capitals, with a capital first, a capital last, both.
std::string spelled(std::string_view word, int spelling)
{
    std::string text(word);
    const auto capital = [](char& c) { c = static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
    if (spelling == 1)
        std::for_each(text.begin(), text.end(), capital);
    if (spelling == 2 || spelling == 4)
        capital(text.front());
    if (spelling == 3 || spelling == 4)
        capital(text.back());
    return text;
}

template <size_t count>
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& pattern, const std::array<std::string_view, count>& words)
{
    for (int spelling = 0; spelling < spellings; ++spelling) {
        std::vector<std::filesystem::path> files;
        for (const std::string_view word : words)
            files.push_back(fileNamed(pattern, {.face = spelled(word, spelling)}));
        std::error_code error;
        if (std::all_of(files.begin(), files.end(), [&](const auto& file) { return std::filesystem::exists(file, error); }))
            return files;
    }
    return {};
}

/// Six square files as one stacked cube. Each is read as its rows are asked for.
class StackedFaces final : public ImageReader {
public:
    StackedFaces(const std::string& probe, const std::vector<std::filesystem::path>& files, const ProbeReading& reading)
    {
        for (const std::filesystem::path& file : files) {
            m_faces.push_back(openImage(file, reading));
            const ImageFileInfo& face = m_faces.back()->info();
            const int edge = m_faces.front()->info().width;
            if (face.width != face.height || face.width != edge)
                throw FileError(file.string(), "is " + std::to_string(face.width) + " x " + std::to_string(face.height) +
                                                   " texels; the six faces of a cube must be squares of one size, here " +
                                                   std::to_string(edge));
            for (const std::string& note : face.notes)
                m_info.notes.push_back(file.filename().string() + ": " + note);
        }
        std::vector<std::string> notes = std::move(m_info.notes);
        m_info = m_faces.front()->info();
        m_info.notes = std::move(notes);
        m_info.path = probe;
        m_info.height *= 6;
        m_info.levels = 1;
        m_info.envmap.clear();
        m_info.attributes["mirrorball:parameterization"] = "cube";
        std::string names;
        for (const std::filesystem::path& file : files)
            names += (names.empty() ? "" : ", ") + file.filename().string();
        const bool isOwn = std::all_of(m_faces.begin(), m_faces.end(),
                                       [](const auto& face) { return face->info().attributes.contains("mirrorball:parameterization"); });
        assume(m_info.assumed, {"handedness",
                                "faces as OpenGL draws them",
                                isOwn ? "Mirrorball wrote them" : "the convention of such names",
                                isOwn ? Certainty::Certain : Certainty::Likely,
                                {"mirrored: --mirror x", "another order or turn: --faces"}});
        assume(m_info.assumed, {"files", "six cube faces, +X -X +Y -Y +Z -Z: " + names, "their names"});
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const int n = m_info.width;
        for (int y = firstRow; y < firstRow + rows;) {
            const int face = y / n, count = std::min(firstRow + rows - y, (face + 1) * n - y);
            m_faces[static_cast<size_t>(face)]->readRows(y % n, count, texels);
            texels += 3 * static_cast<size_t>(n) * static_cast<size_t>(count);
            y += count;
        }
    }

private:
    std::vector<std::unique_ptr<ImageReader>> m_faces{};
    ImageFileInfo m_info{};
};

/// A picture in memory.
class HeldImage final : public ImageReader {
public:
    HeldImage(Image image, ImageFileInfo info) : m_image(std::move(image)), m_info(std::move(info)) {}
    const ImageFileInfo& info() const override { return m_info; }
    void readRows(int firstRow, int rows, float* texels) override
    {
        std::copy_n(m_image.row(firstRow), static_cast<size_t>(rows) * static_cast<size_t>(m_image.width) * 3, texels);
    }

private:
    Image m_image;
    ImageFileInfo m_info;
};

std::unique_ptr<ImageReader> joinedHalves(const std::string& probe, const std::vector<std::filesystem::path>& files,
                                          const ProbeReading& reading)
{
    std::array<ParaboloidHalf, 2> halves{};
    ImageFileInfo info = openImage(files[0], reading)->info();
    for (size_t i = 0; i < 2; ++i) {
        const auto reader = openImage(files[i], reading, Channels::ColorAndOpacity);
        const ImageFileInfo& own = reader->info();
        if (own.width != own.height || own.width != info.width)
            throw FileError(files[i].string(), "is " + std::to_string(own.width) + " x " + std::to_string(own.height) +
                                                   " texels; the halves of a paraboloid must be squares of one size, here " +
                                                   std::to_string(info.width));
        halves[i].hasAlpha = std::any_of(own.assumed.begin(), own.assumed.end(),
                                         [](const Assumption& a) { return a.topic == "alpha" && !a.value.starts_with("none"); });
        halves[i].rgba = Image(own.width, own.height, 4);
        reader->readRows(0, own.height, halves[i].rgba.texels.data());
        if (own.sampleType.starts_with("uint")) // multiplied by their alpha, which is a weight here
            divideByAlpha(halves[i].rgba);
    }
    const int border = borderOf(info);
    info.path = probe;
    info.width *= 2;
    info.envmap.clear();
    info.attributes["mirrorball:parameterization"] = "paraboloid";
    info.levels = 1;
    assume(info.assumed,
           {"files", "the front and back half of a dual paraboloid: " + files[0].filename().string() + ", " + files[1].filename().string(),
            "their names"});
    assume(info.assumed,
           {"handedness", "+X right in both halves", "the convention of such names", Certainty::Likely, {"mirrored: --mirror x"}});
    assume(info.assumed, {"alpha", halves[0].hasAlpha ? "how far each half is believed" : "none: each half is believed in its circle",
                          "the files' channels"});
    return std::make_unique<HeldImage>(joinHalves(halves[0], halves[1], border), std::move(info));
}

} // namespace

std::vector<std::filesystem::path> probeFiles(const std::string& probe)
{
    const std::filesystem::path path(probe);
    std::error_code error;
    if (!namesFaces(path) || std::filesystem::exists(path, error))
        return {path};
    for (const Words& words : faceWords)
        if (std::vector<std::filesystem::path> files = filesOf(path, words); !files.empty())
            return files;
    return filesOf(path, halfNames);
}

std::optional<std::string> faceFamily(const std::filesystem::path& path)
{
    const std::string stem = path.stem().string();
    for (const Words& words : faceWords) {
        if (words[0].size() == 1)
            continue; // too short to mean anything by itself
        for (const std::string_view word : words)
            for (int spelling = 0; spelling < spellings; ++spelling) {
                const std::string own = spelled(word, spelling);
                if (!stem.ends_with(own))
                    continue;
                const auto pattern = path.parent_path() / (stem.substr(0, stem.size() - own.size()) + "%s" + path.extension().string());
                if (filesOf(pattern, words).size() == words.size())
                    return pattern.string();
            }
    }
    return std::nullopt;
}

std::unique_ptr<RepairedReader> openProbePicture(const std::string& probe, const ProbeReading& reading, NegativePolicy negatives)
{
    const std::vector<std::filesystem::path> files = probeFiles(probe);
    if (files.empty())
        throw FileError(probe, "there are no six files of that name with px nx py ny pz nz (or posx negx ..., +X -X ..., right left top "
                               "bottom front back) for the %s, nor two with front and back; check the name");
    auto picture = files.size() == 6   ? std::make_unique<StackedFaces>(probe, files, reading)
                   : files.size() == 2 ? joinedHalves(probe, files, reading)
                                       : openImage(files[0], reading);
    return std::make_unique<RepairedReader>(std::move(picture), negatives);
}

} // namespace mirrorball
