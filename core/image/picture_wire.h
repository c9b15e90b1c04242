#pragma once

#include "openimageio_module.h"

#include "core/base/wire.h"

/// What the helper is asked for, and what it tells of a picture that it has opened.
namespace mirrorball {

template <class Value, class Visit>
void visitAssumption(Value& assumption, Visit&& visit)
{
    auto& [topic, value, why, certainty, others] = assumption;
    visit(topic, value, why, certainty, others);
}

inline WireWriter& operator<<(WireWriter& writer, const Assumption& assumption)
{
    visitAssumption(assumption, [&](const auto&... members) { (writer << ... << members); });
    return writer;
}
inline WireReader& operator>>(WireReader& reader, Assumption& assumption)
{
    visitAssumption(assumption, [&](auto&... members) { (reader >> ... >> members); });
    if (static_cast<unsigned>(assumption.certainty) > static_cast<unsigned>(Certainty::Guess))
        assumption.certainty = Certainty::Guess;
    return reader;
}

namespace openimageio {

/// Hands every member that travels to `visit`: all but the path. Members added to ImageFileInfo must be named here, or this does not
/// compile.
template <class Info, class Visit>
void visitInfo(Info& info, Visit&& visit)
{
    auto& [path, format, width, height, offsetX, offsetY, blackTexels, orientation, channels, sampleType, tiled, levels, parts, compression,
           envmap, attributes, assumed, notes] = info;
    static_cast<void>(path);
    visit(format, width, height, offsetX, offsetY, blackTexels, orientation, channels, sampleType, tiled, levels, parts, compression,
          envmap, attributes, assumed, notes);
}

template <class Request, class Visit>
void visitRequest(Request& request, Visit&& visit)
{
    auto& [part, level, keepsEncoding, channels] = request;
    visit(part, level, keepsEncoding, channels);
}

inline std::string toWire(const ImageFileInfo& info)
{
    WireWriter writer;
    visitInfo(info, [&](const auto&... members) { (writer << ... << members); });
    return std::move(writer).bytes();
}

/// @return false for bytes that are no picture's
inline bool fromWire(std::string_view bytes, ImageFileInfo& info)
{
    WireReader reader(bytes);
    visitInfo(info, [&](auto&... members) { (reader >> ... >> members); });
    return reader.isDone();
}

} // namespace openimageio
} // namespace mirrorball
