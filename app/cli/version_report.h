#pragma once

#include <string>

namespace mirrorball::cli {

/// What a bug report needs, a line each: version and build, libraries as they are loaded, OpenGL's renderer or why there is none, the
/// helper, processor, memory, and the limits of this process and of files.
std::string versionReport();

} // namespace mirrorball::cli
