#pragma once

#include "openimageio_module.h"

/// Pictures that OpenImageIO decodes, in the helper (core/base/helper_process.h).
namespace mirrorball::openimageio {

/// @param format  OpenImageIO's name of what the file is, by its content
/// @throws FileError; WorkError where there is no helper
std::unique_ptr<RawReader> openForeign(const std::filesystem::path& path, const std::string& format, int level);

} // namespace mirrorball::openimageio
