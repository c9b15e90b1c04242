#pragma once

#include "layer.h"

#include "core/base/field_json.h"

namespace mirrorball {

/// A layer's content in files: {"kind": "silhouette", "width": 0.1, ...}. What is missing takes its default; a kind that is not known is
/// kept as it stands. @throws InvalidArgument naming the field
void readJson(const std::string& path, const nlohmann::json& json, LayerContent& content);
nlohmann::ordered_json writeJson(const LayerContent& content);

} // namespace mirrorball
