#include "version_report.h"

#include "core/base/error.h"
#include "core/base/helper_process.h"
#include "core/base/job.h"
#include "core/preview/offscreen_context.h"
#include "core/report/machine.h"
#include "core/scene/export_estimate.h"

#include <CLI/Version.hpp>
#include <OpenColorIO/OpenColorIO.h>
#include <OpenEXR/OpenEXRConfig.h>
#include <fftw3.h>
#include <nlohmann/json.hpp>
#include <openssl/crypto.h>
#include <png.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdio>

#include <sys/resource.h>
#include <sys/wait.h>

namespace mirrorball::cli {
namespace {

std::string line(const std::string& name, const std::string& value) { return name + ": " + value + "\n"; }

std::string limitText(int resource, bool isBytes)
{
    rlimit limit{};
    if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return "unlimited";
    return isBytes ? byteText(static_cast<std::int64_t>(limit.rlim_cur)) : std::to_string(limit.rlim_cur);
}

/// What a part of the program says of itself, or why it is not to be had: a report must come to its end.
template <typename Ask>
std::string answerOf(Ask&& ask)
{
    try {
        return ask();
    } catch (const std::exception& error) {
        return std::string("none: ") + error.what();
    }
}

/// The helper's libraries, which this process does not load.
std::string helperText()
{
    const std::string program = helperProgram().string();
    std::string text;
    if (std::FILE* const answer = ::popen(("'" + program + "' versions 2>/dev/null").c_str(), "r")) {
        char block[256];
        while (std::fgets(block, sizeof block, answer))
            text += block;
        ::pclose(answer);
    }
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return program + (text.empty() ? ", which does not run" : ", with " + text);
}

} // namespace

std::string versionReport()
{
    const Machine machine = thisMachine();
    std::string text = std::string("mirrorball ") + MIRRORBALL_VERSION + "\n";
    text += line("build", machine.compiler + ", " + machine.build);
    text += line("libraries", "OpenEXR " OPENEXR_VERSION_STRING ", OpenColorIO " + std::string(OCIO_NAMESPACE::GetVersion()) + ", " +
                                  fftw_version + ", libpng " + ::png_get_libpng_ver(nullptr) + ", zlib " + ::zlibVersion() + ", zstd " +
                                  ::ZSTD_versionString() + ", " + ::OpenSSL_version(OPENSSL_VERSION) + ", nlohmann-json " +
                                  std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                                  std::to_string(NLOHMANN_JSON_VERSION_PATCH) + ", CLI11 " CLI11_VERSION);
    text += line("reader of other formats", answerOf([] { return helperText(); }));
    text += line("OpenGL", answerOf([] { return preview::OffscreenContext().description(); }));
    text += line("machine", machine.processor + ", " + std::to_string(machine.cores) + " cores for this process, " +
                                byteText(machine.memoryBytes) + " of memory, " + machine.system);
    text += line("limits of the process", "address space " + limitText(RLIMIT_AS, true) + ", file size " + limitText(RLIMIT_FSIZE, true) +
                                              ", open files " + limitText(RLIMIT_NOFILE, false) + ", processes " +
                                              limitText(RLIMIT_NPROC, false));
    text += line("limits of files", "maps up to 65536 texels an edge, scene and jobs files up to 128 MiB");
    text.pop_back();
    return text;
}

} // namespace mirrorball::cli
