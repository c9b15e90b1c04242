#pragma once

#include "openimageio_module.h"

namespace mirrorball::openimageio {

/// OpenImageIO behind our interface, loaded on first need. @throws WorkError when it is not installed
const Module& module();

/// CPU time that the next call of module() takes, about: nothing once it is loaded.
double loadingSeconds();

} // namespace mirrorball::openimageio
