#include "picture_rows.h"

#include "image_format.h"

#include "core/base/error.h"

namespace mirrorball {

bool writesRows(const std::filesystem::path& path)
{
    const ImageFormat* const format = findFormat(path);
    return format && format->writeRows;
}

void writeRows(const std::filesystem::path& path, const PictureRows& picture, const WriteOptions& options)
{
    if (!writesRows(path))
        throw InvalidArgument(path.string() + ": only .exr files are written row by row");
    AtomicFile file(path);
    writableFormat(path).writeRows(file, picture, options);
    file.commit();
}

} // namespace mirrorball
