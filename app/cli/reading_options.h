#pragma once

#include "core/image/probe_reading.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::cli {

/// The options that say how a probe's file is to be read, as typed: --from and one for each other field of ProbeReading.
class ReadingOptions {
public:
    /// All of them but one that is left out.
    void addTo(CLI::App& command, std::string_view leftOut = {});
    /// @param otherwise  what stands where an option is not given
    /// @throws InvalidArgument naming the option
    ProbeReading parse(const ProbeReading& otherwise = {}) const;

private:
    std::map<std::string, std::string> m_typed{};
};

/// A field's option: "--color-space".
std::string optionOf(const Field& field);

/// Prints what a user should know of a probe's file, a line each on stderr.
void printNotes(const std::string& probe, const std::vector<std::string>& notes);

} // namespace mirrorball::cli
