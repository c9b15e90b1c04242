#pragma once

#include "core/image/image.h"

#include <span>
#include <vector>

namespace mirrorball {

/// Where a cell of a sheet lies.
struct SheetLayout {
    int columns = 1;
    int rows = 1;
};
/// A sheet of `count` cells of about `aspect` (width over height): of the numbers of columns beside that, the one that leaves the fewest
/// cells empty.
SheetLayout sheetLayout(size_t count, double aspect = 1.5);

/// Pictures of one size side by side, in rows, on a background color, which also lies below transparent ones. For 3 or 4 channels (the
/// fourth is the opacity that colors were multiplied by); the sheet has 3.
Image contactSheet(std::span<const Image> pictures, int columns, float background);

/// The part of a sphere map that means something: outside the disc it becomes transparent, with a smooth edge.
Image cutToDisc(Image map);

} // namespace mirrorball
