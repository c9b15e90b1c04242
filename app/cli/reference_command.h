#pragma once

#include <CLI/CLI.hpp>

namespace mirrorball::cli {

/// `mirrorball reference FOLDER`, which --help does not list: writes the man pages and completions that an installation brings, from the
/// declarations of `program`, and the guide's page of the scene file, from those of its fields. Add it last.
void addReferenceCommand(CLI::App& program);

} // namespace mirrorball::cli
