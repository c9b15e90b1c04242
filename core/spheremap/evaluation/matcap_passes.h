#pragma once

#include "evaluate.h"

#include <span>
#include <string>

namespace mirrorball {

/// The two pictures of a matcap whose matt part takes the object's color and whose shine does not: what is shown is color * diffuse +
/// specular.
struct MatcapPasses {
    Image diffuse{};  ///< RGB
    Image specular{}; ///< RGB, black where nothing shines
};

/// Splits a document: diffuse is what it shows without the layers of the given names, specular what these add to it, whatever their blend
/// modes and the layers above them. The passes always add up to the map. Where the named layers take light away, as the bars of a window
/// do, there is no shine: the matt part is as dark as the map.
/// @throws InvalidArgument where no layer has a name; as evaluate()
/// Source: Blender's studio lights, which read passes named "diffuse" and "specular" from an EXR file of any size, half or float, and look
/// 0.8 percent inside the rim
MatcapPasses evaluatePasses(const SphereMapDocument& document, std::span<const std::string> specularLayers, const EvaluateOptions& options,
                            const JobControl& job = {});

/// A picture with a border of so many texels around it, which continue those at its edge: for programs that look inside the rim, and would
/// cut an outline off. Blender's radius is 0.992 of half the edge, so that a border of 2 fits 512 texels. Source: Blender's
/// matcap_uv_compute, whose coordinates are 0.496 n.xy + 0.5
Image bordered(const Image& picture, int texels);

} // namespace mirrorball
