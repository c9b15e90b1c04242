#pragma once

#include "scene.h"

#include <string>

/// Parts of a scene by the words that users call them by, on the command line and in Python.
namespace mirrorball {

/// A material: the name of a preset, or a file. @param parameter  "--material", for messages
/// @throws InvalidArgument naming the presets; FileError
Material materialFromWord(const std::string& parameter, const std::string& word);

/// A scene's probe: builtin:NAME, or a file, whose path becomes absolute, since the scene may be saved anywhere.
std::string probeFromWord(const std::string& word);

} // namespace mirrorball
