#pragma once

#include "scene.h"

#include "core/base/field_json.h"

namespace mirrorball {

/// What of a reading was asked for, under the names that scene files have for it; what was left to the file is left out.
inline nlohmann::ordered_json askedOf(const ProbeReading& reading)
{
    const ProbeReading initial;
    nlohmann::ordered_json all, otherwise, asked = nlohmann::ordered_json::object();
    field_json::Writer writeAll(all), writeOtherwise(otherwise);
    ProbeReading::visitFields(reading, writeAll);
    ProbeReading::visitFields(initial, writeOtherwise);
    for (const auto& [name, value] : all.items())
        if (value != otherwise[name])
            asked[name] = value;
    return asked;
}

} // namespace mirrorball
