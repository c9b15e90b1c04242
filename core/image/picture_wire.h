#pragma once

#include "image_io.h"

#include "core/base/wire.h"

/// What the helper tells of a picture that it has opened.
namespace mirrorball::openimageio {

struct OpenedPicture {
    ImageFileInfo info{}; ///< without its path
    bool isSrgb = false;
};

/// Hands every member that travels to `visit`. Members added to ImageFileInfo must be named here, or this does not compile.
template <class Picture, class Visit>
void visitPicture(Picture& picture, Visit&& visit)
{
    auto& [path, format, width, height, offsetX, offsetY, channels, sampleType, tiled, levels, parts, compression, envmap, attributes] =
        picture.info;
    static_cast<void>(path);
    visit(picture.isSrgb, format, width, height, offsetX, offsetY, channels, sampleType, tiled, levels, parts, compression, envmap,
          attributes);
}

inline std::string toWire(const OpenedPicture& picture)
{
    WireWriter writer;
    visitPicture(picture, [&](const auto&... members) { (writer << ... << members); });
    return std::move(writer).bytes();
}

/// @return false for bytes that are no picture's
inline bool fromWire(std::string_view bytes, OpenedPicture& picture)
{
    WireReader reader(bytes);
    visitPicture(picture, [&](auto&... members) { (reader >> ... >> members); });
    return reader.isDone();
}

} // namespace mirrorball::openimageio
