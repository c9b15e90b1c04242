#pragma once

#include "core/filter/paraboloid.h"

#include <memory>

namespace mirrorball::preview {

/// The paraboloid method's sums in OpenGL (000 section 3.2.5), on an offscreen context of its own. The context and the shaders are made by
/// the first sum: an object that is never asked costs nothing. Afterwards what was current on the calling thread is current again, so that
/// any thread may ask, one at a time; a thread whose current context is not EGL's should not.
class ParaboloidBlur : public ParaboloidDevice {
public:
    ParaboloidBlur();
    ~ParaboloidBlur() override;

    std::vector<glm::vec3> sum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job) override;
    std::string description() override;

private:
    struct Resources;
    Resources& resources();
    std::unique_ptr<Resources> m_resources;
};

} // namespace mirrorball::preview
