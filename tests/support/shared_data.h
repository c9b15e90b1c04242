#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Real probes: a few small ones of the repository's own, and others, with more inputs, that live beside it where they do.
/// Use as: SHARED_DATA_OR_SKIP(path, "probes/x.hdr");
namespace mirrorball::test {

inline std::filesystem::path sharedDataFolder() { return std::filesystem::path(MIRRORBALL_SHARED_DATA); }

/// Latlongs of 192 x 96 texels in tests/probes: a dawn, a field in full sun, a studio's lamps. SOURCES.md tells where they are from.
inline std::vector<std::filesystem::path> smallProbes()
{
    std::vector<std::filesystem::path> paths;
    for (const char* name : {"kiara_1_dawn.hdr", "kloppenheim_05.hdr", "studio_small_03.hdr"})
        paths.push_back(std::filesystem::path(MIRRORBALL_TEST_PROBES) / name);
    return paths;
}

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

/// Those, and the small ones before them.
inline std::vector<std::filesystem::path> realProbes()
{
    std::vector<std::filesystem::path> paths = smallProbes();
    for (std::filesystem::path& path : sharedProbes1k())
        paths.push_back(std::move(path));
    return paths;
}

} // namespace mirrorball::test

#define SHARED_DATA_OR_SKIP(variable, relative)                                                                                            \
    const std::filesystem::path variable = mirrorball::test::sharedDataFolder() / (relative);                                              \
    if (!std::filesystem::exists(variable))                                                                                                \
    GTEST_SKIP() << "needs " << variable << ", which is not beside this checkout"
