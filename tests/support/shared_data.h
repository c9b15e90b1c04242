#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

/// Real probes and other inputs that live beside the repository. Use as: SHARED_DATA_OR_SKIP(path, "probes/x.hdr");
namespace mirrorball::test {

inline std::filesystem::path sharedDataFolder() { return std::filesystem::path(MIRRORBALL_SHARED_DATA); }

/// The latlong probes of 1024 x 512 texels that lie directly in the probes folder; empty where the folder is absent.
inline std::vector<std::filesystem::path> sharedProbes1k()
{
    std::vector<std::filesystem::path> paths;
    const auto folder = sharedDataFolder() / "probes";
    if (!std::filesystem::is_directory(folder))
        return paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".hdr")
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

} // namespace mirrorball::test

#define SHARED_DATA_OR_SKIP(variable, relative)                                                                                            \
    const std::filesystem::path variable = mirrorball::test::sharedDataFolder() / (relative);                                              \
    if (!std::filesystem::exists(variable))                                                                                                \
    GTEST_SKIP() << "needs " << variable << ", which is not beside this checkout"
