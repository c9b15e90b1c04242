#pragma once

#include "probe_file.h"
#include "reproject.h"

namespace mirrorball {

/// A probe read and resampled: ProbeFile::read() and reproject() in one, with the same result. A file whose rows stand for themselves is
/// read once and never held where the target is smaller throughout (canReprojectRows()), so that a latlong of any size takes little memory.
/// @return the resampled map; its stages are "read and resample", or those of reading and "resample"
/// @throws FileError, InvalidArgument, Cancelled
Probe readResampled(ProbeFile file, const ReprojectOptions& options, const JobControl& job);

} // namespace mirrorball
