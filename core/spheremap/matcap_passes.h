#pragma once

#include "evaluate.h"

#include <span>
#include <string>

namespace mirrorball {

/// The two pictures of a matcap whose matt part takes the object's colour and whose shine does not: they add up to what is shown.
struct MatcapPasses {
    Image diffuse{};  ///< RGB
    Image specular{}; ///< RGB, black where nothing shines
};

/// Splits a document: the layers of the given names, by themselves over black, and the rest.
/// @throws InvalidArgument where no layer has a name; as evaluate()
/// Source: Blender's studio lights, which read passes named "diffuse" and "specular" from an EXR file
MatcapPasses evaluatePasses(const SphereMapDocument& document, std::span<const std::string> specularLayers, const EvaluateOptions& options,
                            const JobControl& job = {});

} // namespace mirrorball
