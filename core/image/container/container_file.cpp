#include "container_file.h"

#include "babylon_env.h"
#include "cube_orientation.h"
#include "dds.h"
#include "ktx1.h"
#include "ktx2.h"

#include "core/base/error.h"
#include "core/image/input_checks.h"
#include "core/image/openimageio_loader.h"

#include <algorithm>
#include <bit>

namespace mirrorball {

namespace {

/// The largest texture that is read (input_checks.h), as floats with all levels, and what stands before it.
constexpr std::uintmax_t largestFile = std::uintmax_t{16} * maxTexels / 3 * 4 + (std::uintmax_t{1} << 22);

ContainedTexture ofTexture(const std::string& format, Texture texture)
{
    return {format, std::string(traits(texture.format).name), std::move(texture)};
}

/// The faces of a .dds cube as OpenImageIO lays them out: two columns, three rows, +X -X +Y -Y +Z -Z.
Image stackedFaces(const Image& grid)
{
    const int n = grid.width / 2;
    Image stacked(n, 6 * n, 3);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            std::copy_n(grid.texel(face % 2 * n, face / 2 * n + y), static_cast<size_t>(n) * 3, stacked.row(face * n + y));
    return stacked;
}

Image wholeImage(ImageReader& reader)
{
    Image image(reader.info().width, reader.info().height, 3);
    reader.readRows(0, image.height, image.texels.data());
    return image;
}

/// Levels that are no longer 2 : 3 are too small for the grid to be told apart and end the chain.
ContainedTexture decodedByOpenImageIo(const std::filesystem::path& path)
{
    ContainedTexture result{"dds", "compressed", {}};
    const std::unique_ptr<ImageReader> first = openimageio::open(path, "DDS ", {});
    const int width = first->info().width, height = first->info().height;
    const bool cube = 3 * width == 2 * height;
    result.texture.faces = cube ? 6 : 1;
    const int edge = cube ? width / 2 : width;
    const int most = std::bit_width(static_cast<unsigned>(std::max(edge, cube ? edge : height))); // whatever its header claims
    for (int level = 0; level < std::min(std::max(1, first->info().levels), most); ++level) {
        const std::unique_ptr<ImageReader> reader = level == 0 ? nullptr : openimageio::open(path, "DDS ", {.level = level});
        ImageReader& source = reader ? *reader : *first;
        Image image = wholeImage(source);
        if (cube && 3 * image.width != 2 * image.height)
            break;
        result.texture.levels.push_back(cube ? stackedFaces(image) : std::move(image));
    }
    return result;
}

/// Alpha is left out: light has none.
Image rgbOf(const Image& image)
{
    if (image.channels == 3)
        return image;
    Image rgb(image.width, image.height, 3);
    const auto channels = static_cast<size_t>(image.channels);
    for (size_t i = 0, o = 0; i < image.texels.size(); i += channels, o += 3)
        for (size_t c = 0; c < 3; ++c)
            rgb.texels[o + c] = image.texels[i + (channels < 3 ? 0 : c)];
    return rgb;
}

/// The halves of a paraboloid map, one below the other, or back.
Image slicesOf(const Image& map)
{
    const int n = map.height;
    Image slices(n, 2 * n, 3);
    for (int y = 0; y < 2 * n; ++y)
        std::copy_n(map.texel(y / n * n, y % n), static_cast<size_t>(n) * 3, slices.row(y));
    return slices;
}
Image halvesOf(const Image& slices)
{
    const int n = slices.width;
    Image map(2 * n, n, 3);
    for (int y = 0; y < 2 * n; ++y)
        std::copy_n(slices.row(y), static_cast<size_t>(n) * 3, map.texel(y / n * n, y % n));
    return map;
}

bool areHalves(const Texture& texture) { return texture.slices == 2 && texture.levels.front().height == 2 * texture.levels.front().width; }

bool isParaboloid(const WriteOptions& options)
{
    const auto found = options.attributes.find("mirrorball:parameterization");
    return found != options.attributes.end() && found->second == "paraboloid";
}

Texture textureOf(const std::vector<Image>& levels, const WriteOptions& options)
{
    Texture texture{.faces = options.faces, .format = options.sampleType == SampleType::Half ? TexelFormat::Half : TexelFormat::Float};
    for (const Image& level : levels)
        texture.levels.push_back(rgbOf(level));
    return texture;
}

void write(AtomicFile& file, const std::string& bytes) { file.write(bytes.data(), bytes.size()); }

/// A level of a texture in memory, handed out in rows.
class LevelReader final : public ImageReader {
public:
    LevelReader(const std::filesystem::path& path, const ContainedTexture& contained, Image image) : m_image(std::move(image))
    {
        m_info.path = path;
        m_info.format = contained.format;
        m_info.width = m_image.width;
        m_info.height = m_image.height;
        m_info.channels = contained.texture.format == TexelFormat::Half || contained.texture.format == TexelFormat::Float ? 4 : 3;
        m_info.sampleType = contained.texels;
        m_info.levels = static_cast<int>(contained.texture.levels.size());
        if (contained.texture.faces == 6)
            m_info.attributes["mirrorball:parameterization"] = "cube";
        if (areHalves(contained.texture))
            m_info.attributes["mirrorball:parameterization"] = "paraboloid";
        assume(m_info.assumed, {"encoding", "linear, Rec.709 primaries", "texels of type " + m_info.sampleType, Certainty::Likely});
        assume(m_info.assumed, contained.format == "env"
                                   ? Assumption{"handedness", "mirrored and upside down faces, which is undone", "Babylon.js' loader"}
                                   : Assumption{"handedness",
                                                areHalves(contained.texture) ? "+X right in both halves" : "faces as OpenGL draws them",
                                                "the format's definition; engines also store mirrored ones",
                                                Certainty::Likely,
                                                {"mirrored: --mirror x", "another order or turn: --faces"}});
    }

    const ImageFileInfo& info() const override { return m_info; }
    void readRows(int firstRow, int rows, float* rgb) override
    {
        std::copy_n(m_image.row(firstRow), static_cast<size_t>(rows) * static_cast<size_t>(m_image.width) * 3, rgb);
    }

private:
    Image m_image;
    ImageFileInfo m_info{};
};

} // namespace

bool isContainer(std::string_view firstBytes)
{
    return ktx1::hasSignature(firstBytes) || ktx2::hasSignature(firstBytes) || dds::hasSignature(firstBytes) ||
           babylon_env::hasSignature(firstBytes);
}

ContainedTexture readContainer(std::string_view bytes, const std::string& name)
{
    if (ktx1::hasSignature(bytes))
        return ofTexture("ktx", ktx1::read(bytes, name));
    if (ktx2::hasSignature(bytes))
        return ofTexture("ktx2", ktx2::read(bytes, name));
    if (dds::hasSignature(bytes))
        return ofTexture("dds", dds::read(bytes, name));
    if (babylon_env::hasSignature(bytes)) {
        ContainedTexture result{"env", "rgbd", {}};
        result.texture.levels = babylon_env::read(bytes, name).levels;
        return result;
    }
    throw FileError(name, "is no .ktx, .ktx2, .dds or .env file; export or download it again");
}

ContainedTexture readContainer(OpenedFile file)
{
    const std::string bytes = file.readAll(largestFile);
    if (dds::hasSignature(bytes) && dds::isForeign(bytes, file.path().string()))
        return decodedByOpenImageIo(file.path());
    return readContainer(bytes, file.path().string());
}

ContainedTexture readContainer(const std::filesystem::path& path) { return readContainer(OpenedFile(path)); }

std::unique_ptr<ImageReader> openContainer(OpenedFile file, int level)
{
    const std::filesystem::path path = file.path();
    const ContainedTexture contained = readContainer(std::move(file));
    const std::vector<Image>& levels = contained.texture.levels;
    if (level < 0 || level >= static_cast<int>(levels.size()))
        throw FileError(path.string(), "has " + std::to_string(levels.size()) + " levels, counted from 0; ask for one of them");
    Image image = levels[static_cast<size_t>(level)];
    if (contained.format == "env") // the one container whose reader is known: its faces say where they are
        image = fromStored(image, {.axes = mirroredInX().axes, .bottomUp = true});
    if (areHalves(contained.texture))
        image = halvesOf(image);
    return std::make_unique<LevelReader>(path, contained, std::move(image));
}

void writeKtx1(AtomicFile& file, const std::filesystem::path&, const std::vector<Image>& levels, const WriteOptions& options)
{
    write(file, ktx1::write(textureOf(levels, options)));
}

void writeKtx2(AtomicFile& file, const std::filesystem::path&, const std::vector<Image>& levels, const WriteOptions& options)
{
    write(file, ktx2::write(textureOf(levels, options)));
}

void writeDds(AtomicFile& file, const std::filesystem::path&, const std::vector<Image>& levels, const WriteOptions& options)
{
    Texture texture = textureOf(levels, options);
    if (isParaboloid(options)) {
        texture.slices = 2;
        for (Image& level : texture.levels)
            level = slicesOf(level);
    }
    write(file, dds::write(texture, texture.slices > 1 ? dds::Header::Dx10 : dds::Header::Direct3D9));
}

} // namespace mirrorball
