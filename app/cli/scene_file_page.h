#pragma once

#include <string>

namespace mirrorball::cli {

/// The guide's page of the scene file, docs/scene-file.md: every field with its default, range and meaning, from sceneFields().
std::string sceneFilePage();

} // namespace mirrorball::cli
