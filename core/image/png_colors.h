#pragma once

#include "picture_decoder.h"

#include <filesystem>

namespace mirrorball {

/// Reads what the chunks of a PNG file before its picture say of its colors: cICP, sRGB, gAMA, cHRM. (OpenImageIO rounds the gamma and
/// leaves out the rest.) What is damaged is as good as absent. Source: PNG, third edition, section 11.3.2.
void readPngColors(const std::filesystem::path& path, StoredColors& colors);

} // namespace mirrorball
