#include "display_transform.h"

#include "core/base/error.h"
#include "core/base/file_log.h"
#include "core/image/input_checks.h"
#include "core/image/ocio_tables.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cstdlib>

namespace mirrorball::preview {

namespace ocio = OCIO_NAMESPACE;

namespace {

/// All of a library's text in one line: the first line of a compiler's message alone says too little.
std::string inOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 32; }, ' ');
    std::string line = oneLine(text);
    while (line.find("  ") != std::string::npos)
        line.erase(line.find("  "), 1);
    return line.size() > 240 ? oneLine(line.substr(0, 240)) : line;
}

/// Runs `work`; what OpenColorIO has to say becomes an error of the field.
template <typename Work>
auto namingField(const std::string& field, Work&& work)
{
    try {
        return work();
    } catch (const ocio::Exception& error) {
        throw InvalidArgument(field + ": " + inOneLine(error.what()));
    }
}

ocio::ConstConfigRcPtr openConfig(const std::string& config)
{
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    std::string path = config;
    if (config == "env") {
        const char* named = std::getenv("OCIO");
        if (!named || !*named)
            throw InvalidArgument("view.display.config: is env, but $OCIO is not set; set it to a .ocio file");
        path = named;
    }
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > (std::uintmax_t{64} << 20))
        throw InvalidArgument("view.display.config: " + path + " is no OpenColorIO configuration; name a .ocio file");
    noteRead(path);
    return namingField("view.display.config", [&] { return ocio::Config::CreateFromFile(path.c_str()); });
}

/// The configuration's name for our working space.
std::string workingSpace(const ocio::Config& config)
{
    for (const char* name : {"lin_rec709", "lin_srgb", "Linear Rec.709 (sRGB)", "lin_rec709_scene", "Utility - Linear - sRGB", "Linear",
                             "linear", ocio::ROLE_SCENE_LINEAR})
        if (const auto space = config.getColorSpace(name))
            return space->getName();
    throw InvalidArgument("view.display.config: has no linear Rec.709 space and no scene_linear role; use another configuration");
}

std::vector<std::string> viewsOf(const ocio::Config& config, const std::string& display)
{
    std::vector<std::string> views{config.getDefaultView(display.c_str())};
    for (int i = 0; i < config.getNumViews(display.c_str()); ++i)
        if (const std::string view = config.getView(display.c_str(), i); view != views.front())
            views.push_back(view);
    return views;
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

std::vector<std::string> displaysOf(const ocio::Config& config)
{
    std::vector<std::string> displays{config.getDefaultDisplay()};
    for (int i = 0; i < config.getNumDisplays(); ++i)
        if (const std::string display = config.getDisplay(i); display != displays.front())
            displays.push_back(display);
    return displays;
}

std::string choose(const std::string& field, const std::string& wanted, const std::vector<std::string>& known)
{
    if (wanted.empty())
        return known.front();
    if (std::find(known.begin(), known.end(), wanted) == known.end())
        throw InvalidArgument(field + ": '" + inOneLine(wanted) + "' is not in the configuration; it has " + listed(known));
    return wanted;
}

void addTables(DisplayTransform& transform, const ocio::GpuShaderDesc& description)
{
    for (unsigned i = 0; i < description.getNumTextures(); ++i) {
        const char *texture = nullptr, *sampler = nullptr;
        unsigned width = 0, height = 0;
        ocio::GpuShaderDesc::TextureType type{};
        ocio::Interpolation interpolation{};
        description.getTexture(i, texture, sampler, width, height, type, interpolation);
        const float* values = nullptr;
        description.getTextureValues(i, values);
        const int channels = type == ocio::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
        const size_t count = size_t{width} * height * static_cast<size_t>(channels);
        transform.tables.push_back({.sampler = sampler,
                                    .width = static_cast<int>(width),
                                    .height = static_cast<int>(height),
                                    .depth = 1,
                                    .channels = channels,
                                    .isNearest = interpolation == ocio::INTERP_NEAREST,
                                    .values = {values, values + count}});
    }
    for (unsigned i = 0; i < description.getNum3DTextures(); ++i) {
        const char *texture = nullptr, *sampler = nullptr;
        unsigned edge = 0;
        ocio::Interpolation interpolation{};
        description.get3DTexture(i, texture, sampler, edge, interpolation);
        const float* values = nullptr;
        description.get3DTextureValues(i, values);
        const int size = static_cast<int>(edge);
        transform.tables.push_back({.sampler = sampler,
                                    .width = size,
                                    .height = size,
                                    .depth = size,
                                    .isNearest = interpolation == ocio::INTERP_NEAREST || interpolation == ocio::INTERP_TETRAHEDRAL,
                                    .values = {values, values + size_t{edge} * edge * edge * 3}});
    }
}

} // namespace

std::shared_ptr<const DisplayTransform> displayTransform(const DisplayChoice& choice)
{
    const ocio::ConstConfigRcPtr config = openConfig(choice.config);
    if (config->getNumDisplays() == 0)
        throw InvalidArgument("view.display.config: the configuration has no display; use another one");
    auto made = std::make_shared<DisplayTransform>();
    made->display = choose("view.display.display", choice.display, displaysOf(*config));
    made->view = choose("view.display.view", choice.view, viewsOf(*config, made->display));
    namingField("view.display.config", [&] {
        const auto transform = ocio::DisplayViewTransform::Create();
        transform->setSrc(workingSpace(*config).c_str());
        transform->setDisplay(made->display.c_str());
        transform->setView(made->view.c_str());
        auto description = ocio::GpuShaderDesc::CreateShaderDesc();
        description->setLanguage(ocio::GPU_LANGUAGE_GLSL_4_0);
        description->setFunctionName("ocioDisplay");
        description->setResourcePrefix("ocio_");
        const ocio::ConstProcessorRcPtr processor = config->getProcessor(transform);
        noteTables(*processor);
        processor->getDefaultGPUProcessor()->extractGpuShaderInfo(description);
        made->glsl = description->getShaderText();
        addTables(*made, *description);
    });
    return made;
}

std::vector<DisplayOffer> displayOffers(const std::string& config)
{
    const ocio::ConstConfigRcPtr opened = openConfig(config);
    std::vector<DisplayOffer> offers;
    for (const std::string& display : displaysOf(*opened))
        offers.push_back({display, viewsOf(*opened, display)});
    return offers;
}

} // namespace mirrorball::preview
