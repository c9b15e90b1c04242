#include "program.h"

#include <gtest/gtest.h>

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::TemporaryFolder;

/// Counts how often a file is opened, by any process, as the system tells it.
class OpenCounter {
public:
    explicit OpenCounter(const std::filesystem::path& file) : m_watch(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
    {
        m_isAble = m_watch >= 0 && inotify_add_watch(m_watch, file.c_str(), IN_OPEN) >= 0;
    }
    OpenCounter(const OpenCounter&) = delete;
    OpenCounter& operator=(const OpenCounter&) = delete;
    ~OpenCounter() { ::close(m_watch); }

    bool isAble() const { return m_isAble; }
    /// Since it was asked last.
    int count()
    {
        int events = 0;
        alignas(inotify_event) std::array<char, 4096> bytes{};
        for (ssize_t got = ::read(m_watch, bytes.data(), bytes.size()); got > 0; got = ::read(m_watch, bytes.data(), bytes.size()))
            for (ssize_t at = 0; at < got; ++events) {
                inotify_event event{};
                std::memcpy(&event, bytes.data() + at, sizeof event);
                at += static_cast<ssize_t>(sizeof event + event.len);
            }
        return events;
    }

private:
    int m_watch;
    bool m_isAble = false;
};

TEST(OpenedOnce, AProbeGoesFromHandToHand)
{
    const TemporaryFolder folder;
    const std::string sky = "convert builtin:sky --to latlong --size 64 -o ";
    for (const std::string name : {"probe.hdr", "probe.exr", "probe.ktx2"}) {
        SCOPED_TRACE(name);
        const std::string probe = (folder / name).string(), out = " -o " + (folder / "out.exr").string();
        ASSERT_EQ(mirrorballRuns(sky + probe).status, 0);
        OpenCounter opened(probe);
        if (!opened.isAble())
            GTEST_SKIP() << "this system does not tell which files are opened (inotify)";
        ASSERT_EQ(mirrorballRuns("info " + probe).status, 0);
        EXPECT_EQ(opened.count(), 1) << "info";
        ASSERT_EQ(mirrorballRuns("convert " + probe + out + " --to cube --size 16").status, 0);
        EXPECT_EQ(opened.count(), 1) << "convert";
        ASSERT_EQ(mirrorballRuns("filter " + probe + out + " --lobe phong --exponent 20 --to cube --size 16").status, 0);
        EXPECT_EQ(opened.count(), 1) << "filter";
        const std::string scene = (folder / "scene.json").string();
        std::ofstream(scene) << R"({"version": 1, "probe": {"source": ")" << name
                             << R"("}, "exports": [{"name": "a", "kind": "specular", "file": "a.exr", "size": 16},)"
                             << R"({"name": "b", "kind": "diffuse", "file": "b.hdr", "size": 8},)"
                             << R"({"name": "c", "kind": "source", "file": "c.exr", "size": 16}]})";
        ASSERT_EQ(mirrorballRuns("export " + scene + " -o " + (folder / "maps").string()).status, 0);
        EXPECT_EQ(opened.count(), 1) << "export of three maps";
        ASSERT_EQ(mirrorballRuns("filter " + probe + out + " --lobe ggx --roughness 0.4 --to cube --size 16 --mips").status, 0);
        EXPECT_EQ(opened.count(), 1) << "a chain";
    }
}

} // namespace
} // namespace mirrorball
