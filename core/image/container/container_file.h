#pragma once

#include "texture.h"

#include "core/base/atomic_file.h"
#include "core/base/opened_file.h"
#include "core/image/image_io.h"

#include <filesystem>
#include <optional>
#include <string_view>

/// Texture containers (.ktx, .ktx2, .dds, .env) as files.
namespace mirrorball {

/// What a container says, and the texture in it.
struct ContainedTexture {
    std::string format{}; ///< "ktx", "ktx2", "dds", "env"
    std::string texels{}; ///< "rgba16f", "r11g11b10", ..., "rgbd", "bc6h"
    Texture texture{};
};

/// Whether a file that begins with these bytes, 16 or all, is a container.
bool isContainer(std::string_view firstBytes);

/// Reads a container in memory; every face and level as it is stored. Compressed .dds textures are not among them.
/// @param name  stands in messages
/// @throws FileError for damaged or foreign data
ContainedTexture readContainer(std::string_view bytes, const std::string& name);

/// The same of a file; block-compressed .dds cubes are decoded by OpenImageIO. @throws FileError
ContainedTexture readContainer(OpenedFile file);
ContainedTexture readContainer(const std::filesystem::path& path);

/// Writers of the table of formats (image_format.h): levels of a cube (options.faces), of a plain picture, or in a .dds of a paraboloid
/// map, whose halves become the two slices of an array, as DirectXTK's dual parabola effect takes them. Half or float texels, the faces as
/// they stand; engines' own orientations are made by exports for them.
void writeKtx1(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options);
void writeKtx2(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options);
void writeDds(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options);

/// One level of a container as an image: a cube's faces one below the other, two square slices side by side as a paraboloid map. @throws
/// FileError
std::unique_ptr<ImageReader> openContainer(OpenedFile file, int level);

} // namespace mirrorball
