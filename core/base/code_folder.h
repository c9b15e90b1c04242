#pragma once

#include <filesystem>
#include <system_error>

#include <dlfcn.h>
#include <sys/auxv.h>

namespace mirrorball {

/// The folder of the file that this code was loaded from: of the program, or of a library inside another program, as the Python module is.
/// What comes with Mirrorball is found from there.
inline std::filesystem::path folderOfThisCode()
{
    static const char inThisFile = 0;
    Dl_info here{}, program{};
    std::error_code ignored;
    const bool known =
        ::dladdr(&inThisFile, &here) != 0 && here.dli_fname && ::dladdr(reinterpret_cast<const void*>(::getauxval(AT_PHDR)), &program) != 0;
    // A program is named as it was called, which may lead nowhere or elsewhere; a library by its file.
    const bool inLibrary = known && here.dli_fbase != program.dli_fbase;
    return (inLibrary ? std::filesystem::canonical(here.dli_fname, ignored) : std::filesystem::read_symlink("/proc/self/exe", ignored))
        .parent_path();
}

} // namespace mirrorball
