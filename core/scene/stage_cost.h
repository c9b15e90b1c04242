#pragma once

#include "core/base/stage.h"
#include "core/sphere/parameterization.h"

/// What the stages of a plan are expected to cost: a guide, right to a factor of two or three on one core of a current server, that says
/// which stages are worth leaving out. Times come from the stages' own records (`--stats`), memory from what a stage leaves behind.
namespace mirrorball {

/// @param isStreamed  row by row, of which only the spectrum stays
StageCost readingCost(const MapLayout& probe, bool isBuiltin, bool isStreamed);
StageCost resamplingCost(const MapLayout& target);
/// The levels below the base.
StageCost pyramidCost(const MapLayout& base);
/// Evaluating a sphere map of so many layers, and where isAuthored each of its levels by itself, finer.
StageCost paintingCost(int size, size_t layers, bool isAuthored);
StageCost savingCost(const MapLayout& map);
StageCost drawingCost(int width, int height);

} // namespace mirrorball
