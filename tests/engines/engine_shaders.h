#pragma once

#include "core/engine/engine_export.h"
#include "core/filter/filter_source.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

/// What the engines' shaders make of prefiltered light on a white ball, run here on our float levels: their lookups, their interpolation
/// between levels, the terms of their reflection models. File and version of each stand at its function.
namespace mirrorball::proof {

/// A pixel of the picture of a ball: unit normal, and what derivatives the shader sees.
struct Pixel {
    glm::dvec3 normal{0.0};
    glm::dvec3 view{0.0, 0.0, 1.0};
    double normalStep = 0.0;     ///< largest component of the normal's screen derivatives
    double normalVariance = 0.0; ///< sum of the squares of both derivatives
};

/// Where radiance is looked up by the model: our levels, or the exact integral, which the engine's own prefilter is judged by as well.
class Radiance {
public:
    virtual ~Radiance() = default;
    /// Prefiltered for a roughness, as the engine's interpolation between levels has it.
    virtual glm::dvec3 specular(const glm::dvec3& d, double roughness) const = 0;
    virtual glm::dvec3 irradianceOverPi(const glm::dvec3& n) const = 0;
};

/// Our levels as the profile's files hold them, before encoding, looked up with trilinear interpolation by the profile's law.
std::unique_ptr<Radiance> ofLevels(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options);

/// Exact for every roughness; `roughnesses` are the ones that will be asked for.
std::unique_ptr<Radiance> ofExactMaps(FilterSource& probe, const std::vector<double>& roughnesses);

/// The nine coefficients, as the files of the profile hold them.
std::unique_ptr<Radiance> ofSh(FilterSource& probe);

/// White metal of a roughness: what the engine's shader shows. @param directions  from the client's axes to ours
glm::dvec3 metal(const std::string& engine, const Radiance& radiance, const Pixel& pixel, double roughness, const glm::dmat3& directions);

/// White matt paint without reflection.
glm::dvec3 diffuse(const Radiance& radiance, const Pixel& pixel, const glm::dmat3& directions);

} // namespace mirrorball::proof
