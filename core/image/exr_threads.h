#pragma once

namespace mirrorball::exr {

/// Starts OpenEXR's worker pool, which is one for the process and empty at first. Does nothing the second time.
void startThreads();

} // namespace mirrorball::exr
