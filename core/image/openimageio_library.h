#pragma once

#include "openimageio_module.h"

namespace mirrorball::openimageio {

/// OpenImageIO behind our interface, loaded on first need. @throws WorkError when it is not installed
const Module& module();

} // namespace mirrorball::openimageio
