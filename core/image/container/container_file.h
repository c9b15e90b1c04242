#pragma once

#include "texture.h"

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
ContainedTexture readContainer(const std::filesystem::path& path);

/// One level of a container as an image: the pictures of the level one below the other. @throws FileError
std::unique_ptr<ImageReader> openContainer(const std::filesystem::path& path, int level);

} // namespace mirrorball
