#include "program.h"

#include "core/image/image_io.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

/// A run and what it took, its helper included.
struct MeasuredRun {
    int status = 0;
    double seconds = 0.0;   ///< processor time
    std::int64_t bytes = 0; ///< most memory of one process
    std::string err{};
};

MeasuredRun measured(const std::vector<std::string>& arguments, const TemporaryFolder& folder)
{
    const std::string err = (folder / "err").string();
    std::vector<char*> words{const_cast<char*>("mirrorball")};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
        ::execv(MIRRORBALL_PROGRAM, words.data());
        ::_exit(127);
    }
    int status = 0;
    rusage usage{};
    ::wait4(process, &status, 0, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), seconds(usage.ru_utime) + seconds(usage.ru_stime),
            std::int64_t{usage.ru_maxrss} * 1024, test::readBytes(err)};
}

std::string big(std::uint32_t number)
{
    return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8), static_cast<char>(number)};
}

std::string big16(unsigned number) { return big(number).substr(2); }

/// A .psd file of so many texels, whose rows are not there.
std::string psd(std::uint32_t width, std::uint32_t height)
{
    return "8BPS" + big16(1) + std::string(6, '\0') + big16(3) + big(height) + big(width) + big16(8) + big16(3) + big(0) + big(0) + big(0) +
           big16(1) + std::string(200, '\1');
}

/// Ends with a header's promise of two thousand million faces.
std::string endlessPly()
{
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2000000000\n"
           "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

TEST(ForeignFiles, HostileOnesCostLittleAndGiveOneLine)
{
    const TemporaryFolder folder;
    struct Hostile {
        const char* name;
        std::string bytes;
        const char* word;
    };
    const std::string dpx = "SDPX" + std::string(2044, '\x7f'), iff = "FOR4" + big(456) + "CIMG" + std::string(452, '\x41');
    for (const Hostile& file : {Hostile{"dpx.hdr", dpx, "no image of a known format"},
                                Hostile{"row.hdr", "#?RADIANCE\n\n-Y 1 +X 259153249\n12345678", "row.hdr"}, Hostile{"dpx.png", dpx, ".png"},
                                Hostile{"a.iff", iff, "no image of a known format"}, Hostile{"a.psd", psd(30000, 30000), "a.psd"},
                                Hostile{"wide.psd", psd(200000, 1000), "wide.psd"}, Hostile{"a.ply", endlessPly(), "a.ply"},
                                Hostile{"a.webp", "RIFF" + std::string(4, '\xff') + "WEBPVP8L" + std::string(300, '\xff'), "a.webp"},
                                Hostile{"a.tif", std::string("II*\0\x08\0\0\0\xff\xff", 10) + std::string(4000, '\x11'), "a.tif"},
                                Hostile{"a.heic", std::string("\0\0\0\x18", 4) + "ftypheic" + std::string(900, '\x7f'), "a.heic"}}) {
        test::writeBytes(folder / file.name, file.bytes);
        const MeasuredRun run = measured({"info", (folder / file.name).string()}, folder);
        EXPECT_EQ(run.status, 2) << file.name << ": " << run.err;
        EXPECT_EQ(test::lines(run.err), 1u) << file.name << ": " << run.err;
        EXPECT_NE(run.err.find(file.word), std::string::npos) << file.name << ": " << run.err;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        EXPECT_LT(run.seconds, 2.0) << file.name;
        EXPECT_LT(run.bytes, std::int64_t{1} << 30) << file.name;
#endif
    }
}

TEST(ForeignFiles, BlankOnesOfEnormousSizeAreRefused)
{
    const TemporaryFolder folder;
    // One bit a texel: 2^26 of them in 8 MiB of zeros, some 8 kB when compressed. Written by another program's hand: python3.
    const std::string script = "import zlib,struct,sys\n"
                               "n=8192\n"
                               "c=lambda t,d:struct.pack('>I',len(d))+t+d+struct.pack('>I',zlib.crc32(t+d))\n"
                               "open(sys.argv[1],'wb').write(b'\\x89PNG\\r\\n\\x1a\\n'+c(b'IHDR',struct.pack('>IIBBBBB',n,n,1,0,0,0,0))+"
                               "c(b'IDAT',zlib.compress(bytes((n//8+1)*n),9))+c(b'IEND',b''))\n";
    test::writeBytes(folder / "make.py", script);
    if (std::system(("python3 " + (folder / "make.py").string() + " " + (folder / "blank.png").string() + " 2>/dev/null").c_str()) != 0)
        GTEST_SKIP() << "there is no python3 here";
    const MeasuredRun run = measured({"info", (folder / "blank.png").string()}, folder);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("8192 x 8192"), std::string::npos) << run.err;
    EXPECT_LT(run.bytes, std::int64_t{1} << 30);
}

// The name of a file says nothing; what is in it does.
TEST(ForeignFiles, AreKnownByTheirContent)
{
    const TemporaryFolder folder;
    Image image(8, 4, 3);
    for (size_t i = 0; i < image.texels.size(); ++i)
        image.texels[i] = static_cast<float>(i % 7) / 7.0f;
    writeImage(folder / "a.tif", image);
    for (const char* name : {"a.hdr", "a.png", "a.jpg", "a.xyz", "a"}) {
        std::filesystem::copy_file(folder / "a.tif", folder / name, std::filesystem::copy_options::overwrite_existing);
        EXPECT_EQ(readImage(folder / name).texels, image.texels) << name;
    }
    for (const char* name : {"b.jpg", "b.bmp", "b.tga", "b.webp", "b.png"}) {
        writeImage(folder / name, image);
        EXPECT_EQ(readImage(folder / name).width, 8) << name;
    }
}

// The helper goes with the program, whatever ends that.
TEST(ForeignFiles, AKilledProgramLeavesNoHelper)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "slow.ply", endlessPly());
    const pid_t process = ::fork();
    if (process == 0) {
        ::execl(MIRRORBALL_PROGRAM, "mirrorball", "info", (folder / "slow.ply").c_str(), nullptr);
        ::_exit(127);
    }
    ::usleep(200'000);
    std::string children;
    std::getline(std::ifstream("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children") >> std::ws, children);
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    std::istringstream list(children);
    for (pid_t helper = 0; list >> helper;) {
        bool isGone = false;
        for (int i = 0; i < 200 && !isGone; ++i) { // its processor time ends it where it is deep in the file
            isGone = ::kill(helper, 0) != 0 || test::readBytes("/proc/" + std::to_string(helper) + "/cmdline").empty();
            ::usleep(100'000);
        }
        EXPECT_TRUE(isGone);
    }
}

} // namespace
} // namespace mirrorball
