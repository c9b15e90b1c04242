#pragma once

#include "core/base/error.h"
#include "core/image/probe_file.h"
#include "support/exr_builders.h"
#include "support/field.h"
#include "support/picture_builders.h"
#include "support/temporary_folder.h"

#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Files as other programs write them: each made of the field of field.h, in the way of its kind.
namespace mirrorball::test {

inline constexpr MapLayout latlong{Parameterization::Latlong, 32, 0};

struct ForeignFile : testing::Test {
    TemporaryFolder folder{};
    std::filesystem::path path = folder / "file.exr";
    Image field = fieldMap(latlong).image;

    Probe read(const ProbeReading& reading = {}) const { return readFile(path.string(), reading); }
    static Probe readFile(const std::string& name, const ProbeReading& reading = {}) { return readProbe(name, {.reading = reading}); }
    static double distance(const Probe& probe) { return distanceFromField(probe.map); }
    static Assumption assumed(const Probe& probe, const std::string& topic)
    {
        for (const Assumption& a : probe.assumed)
            if (a.topic == topic)
                return a;
        return {};
    }

    /// Channels of the picture's colors under these names.
    std::vector<ExrChannel> colors(const std::string& prefix = "") const
    {
        std::vector<ExrChannel> channels = exrChannels(field);
        for (ExrChannel& channel : channels)
            channel.name = prefix + channel.name;
        return channels;
    }
    std::vector<ExrChannel> constants(const std::vector<std::string>& names, float value) const
    {
        std::vector<ExrChannel> channels;
        for (const std::string& name : names)
            channels.push_back({name, std::vector<float>(field.texels.size() / 3, value)});
        return channels;
    }
    void write(const std::vector<std::vector<ExrChannel>>& layers) const
    {
        std::vector<ExrChannel> all;
        for (const auto& layer : layers)
            all.insert(all.end(), layer.begin(), layer.end());
        writeScanlineExr(path, exrHeader(field.width, field.height, all, Imf::FLOAT), all);
    }
    void writeParts(const std::vector<std::pair<std::string, std::vector<ExrChannel>>>& parts) const
    {
        std::vector<Imf::Header> headers;
        for (const auto& [name, channels] : parts) {
            headers.push_back(exrHeader(field.width, field.height, channels, Imf::FLOAT));
            headers.back().setName(name);
            headers.back().setType(Imf::SCANLINEIMAGE);
        }
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
        for (size_t i = 0; i < parts.size(); ++i) {
            std::vector<std::vector<char>> storage;
            Imf::OutputPart part(file, static_cast<int>(i));
            part.setFrameBuffer(exrFrameBuffer(headers[i], parts[i].second, storage));
            part.writePixels(field.height);
        }
    }
};

} // namespace mirrorball::test
