#include "ocio_space.h"

#include "color_space.h"
#include "input_checks.h"
#include "ocio_tables.h"

#include "core/base/error.h"
#include "core/base/file_log.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace mirrorball {

namespace ocio = OCIO_NAMESPACE;

namespace {

std::string knownNames()
{
    std::string text;
    for (const std::string& name : colorSpaceNames())
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

ocio::ConstConfigRcPtr configuration(const std::string& space)
{
    const char* path = std::getenv("OCIO");
    std::error_code error;
    if (!path || !*path)
        throw InvalidArgument("color_space: '" + oneLine(space) + "' is none of " + knownNames() +
                              "; set $OCIO to an OpenColorIO configuration for names of its own");
    if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > (std::uintmax_t{64} << 20))
        throw InvalidArgument("color_space: $OCIO is " + oneLine(path) + ", which is no OpenColorIO configuration; name a .ocio file");
    noteRead(path);
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    return ocio::Config::CreateFromFile(path);
}

} // namespace

std::function<void(float* rgb)> ocioSpace(const std::string& name)
{
    try {
        const ocio::ConstConfigRcPtr config = configuration(name);
        if (!config->getColorSpace(name.c_str()))
            throw InvalidArgument("color_space: '" + oneLine(name) + "' is none of " + knownNames() +
                                  ", nor a space of the configuration in $OCIO");
        glm::mat3 matrix(1.0f);
        std::string target;
        for (const char* linear : {"lin_rec709", "lin_srgb", "Linear Rec.709 (sRGB)", "lin_rec709_scene", "Utility - Linear - sRGB",
                                   "Utility - Linear - Rec.709"})
            if (target.empty() && config->getColorSpace(linear))
                target = linear;
        if (target.empty() && config->hasRole("aces_interchange")) {
            target = "aces_interchange";
            matrix = *primariesToRec709(*colorSpaceFromName("aces2065-1"));
        }
        if (target.empty())
            target = ocio::ROLE_SCENE_LINEAR;
        const ocio::ConstProcessorRcPtr conversion = config->getProcessor(name.c_str(), target.c_str());
        noteTables(*conversion);
        const ocio::ConstCPUProcessorRcPtr processor = conversion->getDefaultCPUProcessor();
        return [processor, matrix](float* rgb) {
            processor->applyRGB(rgb);
            const glm::vec3 color = matrix * glm::vec3(rgb[0], rgb[1], rgb[2]);
            std::copy_n(&color.x, 3, rgb);
        };
    } catch (const ocio::Exception& error) {
        throw InvalidArgument("color_space: OpenColorIO cannot read '" + oneLine(name) + "': " + oneLine(error.what()));
    }
}

} // namespace mirrorball
