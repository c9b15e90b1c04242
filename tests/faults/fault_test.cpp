#include "process.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <thread>

namespace mirrorball {
namespace {

using test::Process;
using test::TemporaryFolder;
using Contents = std::map<std::string, std::string>; ///< bytes by file name

int moments()
{
    const char* wanted = std::getenv("MIRRORBALL_FAULT_MOMENTS");
    return wanted ? std::atoi(wanted) : 20;
}

Contents contentsOf(const std::filesystem::path& folder)
{
    Contents contents;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        contents[entry.path().lexically_relative(folder).string()] = entry.is_regular_file() ? test::readBytes(entry.path()) : "";
    return contents;
}

bool isTemporary(const std::string& name) { return name.find(".mirrorball-tmp") != std::string::npos; }

size_t temporaries(const Contents& contents)
{
    return static_cast<size_t>(std::count_if(contents.begin(), contents.end(), [](const auto& entry) { return isTemporary(entry.first); }));
}

/// A piece of work in two versions that write the same files.
struct Work {
    const char* name;
    std::function<std::vector<std::string>(const std::filesystem::path& folder, int version)> call;
};

std::vector<Work> works(const TemporaryFolder& inputs)
{
    for (const int version : {0, 1})
        test::writeBytes(inputs / ("scene" + std::to_string(version) + ".mirrorball"),
                         R"({"version": 1, "probe": {"source": "builtin:studio", "yaw": )" + std::to_string(40 * version) +
                             R"(}, "exports": [{"name": "a", "kind": "source", "size": 64}, {"name": "b", "kind": "source", "size": 48},)" +
                             R"({"name": "c", "kind": "source", "size": 32, "mips": true, "file": "c_%d.hdr"}]})");
    const auto scene = [&inputs](int version) { return (inputs / ("scene" + std::to_string(version) + ".mirrorball")).string(); };
    return {
        {"export",
         [=](const auto& folder, int version) {
             return std::vector<std::string>{"export", scene(version), "-o", folder};
         }},
        {"paint",
         [](const auto& folder, int version) {
             return std::vector<std::string>{"paint",   version ? "chrome-horizon" : "silhouette", "-o", folder / "p.exr", "--size", "128",
                                             "--levels"};
         }},
        {"save",
         [](const auto& folder, int version) {
             return std::vector<std::string>{"paint",
                                             version ? "chrome-horizon" : "silhouette",
                                             "-o",
                                             folder / "p.png",
                                             "--size",
                                             "32",
                                             "--save-document",
                                             folder / "d.spheremap"};
         }},
    };
}

class Faults : public testing::Test {
protected:
    /// What the work makes in an empty folder, and how long it takes.
    Contents made(const Work& work, int version, double* seconds = nullptr)
    {
        const TemporaryFolder folder;
        const auto start = std::chrono::steady_clock::now();
        Process process(work.call(folder.path(), version));
        EXPECT_EQ(process.wait(), 0) << work.name;
        if (seconds)
            *seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return contentsOf(folder.path());
    }

    /// Starts the new version over the old one's files and sends the signal at a random moment. @return how it ended
    int interrupt(const Work& work, const std::filesystem::path& folder, double longest, int signal)
    {
        Process process(work.call(folder, 1));
        std::this_thread::sleep_for(std::chrono::duration<double>(longest * std::uniform_real_distribution<double>(0.0, 1.1)(m_random)));
        process.signal(signal);
        return process.wait();
    }

    TemporaryFolder m_inputs{};
    std::mt19937 m_random{20000}; // the same moments, as far as a machine allows
};

void writeAll(const std::filesystem::path& folder, const Contents& contents)
{
    for (const auto& [name, bytes] : contents)
        test::writeBytes(folder / name, bytes);
}

/// Every file is one of its two versions, whole. @return how many are new
size_t expectWhole(const Contents& now, const Contents& before, const Contents& after, const char* what)
{
    size_t fresh = 0;
    for (const auto& [name, bytes] : now) {
        if (name.find(".mirrorball-tmp") != std::string::npos)
            continue;
        EXPECT_TRUE(before.contains(name) || after.contains(name)) << what << ": " << name;
        const bool isNew = after.contains(name) && bytes == after.at(name);
        EXPECT_TRUE(isNew || (before.contains(name) && bytes == before.at(name))) << what << ": " << name << " is damaged";
        fresh += isNew;
    }
    return fresh;
}

TEST_F(Faults, AKillAtAnyMomentLeavesOldOrNewFilesAndTheNextRunCleansUp)
{
    for (const Work& work : works(m_inputs)) {
        double seconds = 0.0;
        const Contents before = made(work, 0), after = made(work, 1, &seconds);
        ASSERT_NE(before, after);
        const TemporaryFolder folder;
        for (int i = 0; i < moments(); ++i) {
            writeAll(folder.path(), before);
            interrupt(work, folder.path(), seconds, SIGKILL);
            const Contents now = contentsOf(folder.path());
            const size_t fresh = expectWhole(now, before, after, work.name);
            if (const std::string manifest = "export-manifest.json"; now.contains(manifest) && now.at(manifest) == after.at(manifest)) {
                EXPECT_EQ(fresh, after.size()) << work.name << ": the manifest is renamed last";
            }
            Process again(work.call(folder.path(), 1));
            ASSERT_EQ(again.wait(), 0);
            EXPECT_EQ(contentsOf(folder.path()), after) << work.name;
        }
    }
}

TEST_F(Faults, SignalsLeaveNothingBehindAndEndTheProgram)
{
    for (const Work& work : works(m_inputs)) {
        double seconds = 0.0;
        const Contents before = made(work, 0), after = made(work, 1, &seconds);
        const TemporaryFolder folder;
        for (const int signal : {SIGINT, SIGTERM, SIGHUP})
            for (int i = 0; i < moments() / 4; ++i) {
                writeAll(folder.path(), before);
                const int status = interrupt(work, folder.path(), seconds, signal);
                EXPECT_TRUE((WIFSIGNALED(status) && WTERMSIG(status) == signal) || status == 0) << work.name << " " << status;
                const Contents now = contentsOf(folder.path());
                EXPECT_EQ(temporaries(now), 0u) << work.name;
                expectWhole(now, before, after, work.name);
            }
    }
}

// The renames of one export follow each other; so the files that are there in the end are of one.
TEST_F(Faults, TwoExportsIntoOneFolderLeaveTheFilesOfOne)
{
    const Work work = works(m_inputs).front();
    const Contents first = made(work, 0), second = made(work, 1);
    for (int i = 0; i < std::max(3, moments() / 5); ++i) {
        const TemporaryFolder folder;
        Process one(work.call(folder.path(), 0)), other(work.call(folder.path(), 1));
        EXPECT_EQ(one.wait(), 0);
        EXPECT_EQ(other.wait(), 0);
        Contents now = contentsOf(folder.path());
        now.erase("export-manifest.json"); // each takes over the entries of files that it does not write
        Contents a = first, b = second;
        a.erase("export-manifest.json");
        b.erase("export-manifest.json");
        EXPECT_TRUE(now == a || now == b);
    }
}

TEST_F(Faults, TheManifestHasSizeAndChecksumOfEveryFile)
{
    const Work work = works(m_inputs).front();
    const Contents files = made(work, 0);
    const nlohmann::json manifest = nlohmann::json::parse(files.at("export-manifest.json"));
    EXPECT_EQ(manifest["files"].size(), files.size() - 1);
    for (const auto& entry : manifest["files"]) {
        const std::string& bytes = files.at(entry["file"]);
        EXPECT_EQ(entry["bytes"], bytes.size());
        char sum[16];
        std::snprintf(sum, sizeof sum, "%08lx", ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
        EXPECT_EQ(entry["crc32"], sum) << entry["file"];
    }
}

// A file system of half a megabyte, in a mount of its own.
TEST_F(Faults, AFullDiskIsOneLineAndLeavesTheOldFiles)
{
    const TemporaryFolder folder;
    const auto runs = [&](const std::string& script) {
        const int result = std::system(
            ("unshare -m sh -c 'mount -t tmpfs -o size=512k none " + folder.path().string() + " && " + script + "' 2>/dev/null").c_str());
        return WIFEXITED(result) ? WEXITSTATUS(result) : 255;
    };
    if (runs("true") != 0)
        GTEST_SKIP() << "no file system can be mounted here";
    const std::string out = folder.path().string();
    const std::string scene = (m_inputs / "big.mirrorball").string(), err = (m_inputs / "err").string();
    test::writeBytes(
        m_inputs / "big.mirrorball",
        R"({"version": 1, "exports": [{"name": "a", "kind": "source", "size": 16}, {"name": "b", "kind": "source", "size": 512}]})");
    EXPECT_EQ(runs("echo old >" + out + "/a.exr; " MIRRORBALL_PROGRAM " export " + scene + " -o " + out + " 2>" + err +
                   "; test $? = 1 && test `cat " + out + "/a.exr` = old && test `ls -A " + out + " | wc -l` = 1"),
              0)
        << test::readBytes(err);
    const std::string message = test::readBytes(err);
    EXPECT_NE(message.find(out + "/b.exr: cannot be written: No space left on device"), std::string::npos) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
}

TEST_F(Faults, AClosedPipeEndsTheProgramWithoutAWord)
{
    const TemporaryFolder folder;
    const std::string err = (folder / "err").string();
    for (const char* call : {"presets", "presets --json", "--help", "info builtin:axes --json"})
        for (int i = 0; i < 5; ++i) {
            const int result = std::system((std::string("bash -c '" MIRRORBALL_PROGRAM " ") + call + " 2>" + err +
                                            " | true; s=${PIPESTATUS[0]}; test $s = 141 -o $s = 0'")
                                               .c_str());
            EXPECT_EQ(result, 0) << call;
            EXPECT_EQ(test::readBytes(err), "") << call;
        }
}

} // namespace
} // namespace mirrorball
