#pragma once

#include "core/base/stage.h"
#include "core/sphere/parameterization.h"

#include <filesystem>
#include <span>

/// What the stages of a plan are expected to cost: a guide, right to a factor of two or three on one core of a current server, that says
/// which stages are worth leaving out; the stages of an export together within two. Times are CPU times and come from the stages' own
/// records
/// (`--stats`; build/ci/bin/export_table shows both), memory from what a stage leaves behind.
namespace mirrorball {

/// @param isStreamed  row by row, of which only the spectrum stays
StageCost readingCost(const MapLayout& probe, bool isBuiltin, bool isStreamed);
StageCost resamplingCost(const MapLayout& probe, const MapLayout& target);
/// The levels below the base.
StageCost pyramidCost(const MapLayout& base);
/// Evaluating a sphere map of so many layers, and where isAuthored each of its levels by itself, finer.
StageCost paintingCost(int size, size_t layers, bool isAuthored);
/// Encoding maps as levels of one file, or as files of one format.
StageCost savingCost(const std::filesystem::path& file, std::span<const MapLayout> levels);
/// Seconds for loading what writes a file's format, where this process has not.
double loadingSeconds(const std::filesystem::path& file);
StageCost drawingCost(int width, int height);

/// The exact maps of a BRDF. @param alpha  of the ggx lobe that is as wide
StageCost viewStackCost(double alpha);

} // namespace mirrorball
