#pragma once

#include <cstddef>

namespace mirrorball {

/// coordinate() of many directions in a latlong of n rows, given by coordinate and not normalized.
void latlongCoordinates(int n, size_t count, const double* x, const double* y, const double* z, double* px, double* py);

/// The same, with the column that is within n of `middle` - also beyond the image's sides - and as the position inside a row the share of
/// the row's solid angle above it, to the first order in the row's height: the density grows along it as the colatitude's sine.
void latlongSharePositions(int n, double middle, size_t count, const double* x, const double* y, const double* z, double* px, double* py);

} // namespace mirrorball
