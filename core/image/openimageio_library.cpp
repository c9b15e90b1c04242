#include "openimageio_library.h"

#include "input_checks.h"

#include "core/base/code_folder.h"
#include "core/base/error.h"

#include <atomic>
#include <vector>

#include <dlfcn.h>

namespace mirrorball::openimageio {
namespace {

std::atomic<bool> isLoaded = false;

constexpr const char* moduleFile = "libmirrorball_openimageio.so";

/// Beside the running program or its helper as installed or as built, then where this build installs to.
std::vector<std::filesystem::path> moduleFolders()
{
    const auto program = folderOfThisCode();
    return {program / MIRRORBALL_MODULE_FROM_BIN,
            program / ".." / MIRRORBALL_MODULE_FROM_BIN,
            program / "../lib/mirrorball",
            program / "../lib",
            program / "../../lib",
            MIRRORBALL_MODULE_INSTALLED};
}

const Module& loadModule()
{
    std::string reason = "it is not installed";
    for (const std::filesystem::path& folder : moduleFolders()) {
        const auto file = folder / moduleFile;
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored))
            continue;
        void* const library = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
        if (!library) {
            reason = oneLine(::dlerror());
            continue;
        }
        const auto entry = reinterpret_cast<const Module* (*)()>(::dlsym(library, entryPoint));
        if (entry && entry()->version == moduleVersion)
            return *entry(); // stays loaded: OpenImageIO does not survive being unloaded
        reason = file.string() + " is of another version";
    }
    throw WorkError("formats other than .exr and .hdr need " + std::string(moduleFile) + ", which cannot be loaded (" + reason +
                    "); reinstall Mirrorball or convert the image to .exr");
}

} // namespace

const Module& module()
{
    static const Module& loaded = loadModule(); // a failure is tried again on the next use
    isLoaded = true;
    return loaded;
}

double loadingSeconds() { return isLoaded ? 0.0 : 0.25; }

} // namespace mirrorball::openimageio
