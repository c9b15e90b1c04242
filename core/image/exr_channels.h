#pragma once

#include "probe_reading.h"

#include <ImfChannelList.h>
#include <ImfMultiPartInputFile.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Which of the parts, layers and channels of an OpenEXR file are the picture.
namespace mirrorball::exr {

/// Which channels of a part are read as red, green and blue. An empty name stands for a channel that is not there (0; opacity: 1).
struct ColorChannels {
    std::array<std::string, 3> rgb{};
    std::string alpha{};
    bool luminanceChroma = false; ///< Y with subsampled RY and BY
    bool isGray() const { return !luminanceChroma && rgb[0] == rgb[1] && rgb[1] == rgb[2]; }
};

/// A picture that a file holds.
struct Picture {
    int part = 0;
    std::string partName{};
    std::string layer{}; ///< without its dot; empty: channels without a layer
    ColorChannels channels{};
};

/// The picture that is read, and what was assumed for it.
struct ChosenPicture {
    Picture picture{};
    std::vector<Assumption> assumed{}; ///< part, layer
};

/// Chooses among all flat parts and their layers: what has red, green and blue wins over luminance (Y, with RY and BY where it is
/// luminance/chroma coded, but never beside an X or Z: that is a vector), and that over a lone channel; of several, a plain or a beauty
/// name over an unknown one, and that over the names of auxiliary passes (albedo, normal, depth, diffuse, ...); the left eye over the
/// right. A part or layer that is asked for is taken whatever it is called, and X, Y, Z are its colors then.
/// @throws FileError that says why there is none, or what there is to choose from
ChosenPicture choosePicture(const std::string& path, const Imf::MultiPartInputFile& file, const ProbeReading& reading);

/// The first pass of that name in any part. Source: Blender's multilayer files, LAYER.PASS.CHANNEL.
std::optional<Picture> findPass(const Imf::MultiPartInputFile& file, const std::string& pass);

} // namespace mirrorball::exr
