#include "program.h"

#include "core/base/sanitized.h"
#include "core/image/image_io.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

// AddressSanitizer keeps what was given back for a while and puts red zones around the rest.
#ifdef MIRRORBALL_SANITIZED
constexpr std::int64_t mostMemory = std::int64_t{4} << 30;
#else
constexpr std::int64_t mostMemory = std::int64_t{1} << 30;
#endif

/// How a run ended that may take 1 GiB and two seconds of processor time, and its helper as much.
struct LimitedRun {
    int status = 0;         ///< above 128: it was ended
    std::int64_t bytes = 0; ///< most memory of one process
    std::string err{};
};

LimitedRun limited(const std::vector<std::string>& arguments, const TemporaryFolder& folder)
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
#ifndef MIRRORBALL_SANITIZED
        const rlimit seconds{2, 2}, memory{rlim_t{1} << 30, rlim_t{1} << 30};
        ::setrlimit(RLIMIT_CPU, &seconds);
        ::setrlimit(RLIMIT_AS, &memory);
#endif
        ::execv(MIRRORBALL_PROGRAM, words.data());
        ::_exit(127);
    }
    int status = 0;
    rusage usage{};
    ::wait4(process, &status, 0, &usage);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), std::int64_t{usage.ru_maxrss} * 1024, test::readBytes(err)};
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

std::string little(std::uint64_t number, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text.push_back(static_cast<char>(number >> (8 * i)));
    return text;
}

/// An .exr file of RGB floats whose rows are not there. @param compression  as the format numbers them: 9 is DWAB, 256 rows at a time
std::string exr(int width, int height, char compression)
{
    const auto attribute = [](const char* name, const char* type, const std::string& value) {
        return name + std::string(1, '\0') + type + std::string(1, '\0') + little(value.size(), 4) + value;
    };
    std::string channels;
    for (const char* name : {"B", "G", "R"})
        channels += name + std::string(1, '\0') + little(2, 4) + little(0, 4) + little(1, 4) + little(1, 4);
    const std::string window = little(0, 8) + little(static_cast<unsigned>(width - 1), 4) + little(static_cast<unsigned>(height - 1), 4);
    return little(20000630, 4) + little(2, 4) + attribute("channels", "chlist", channels + '\0') +
           attribute("compression", "compression", {compression}) + attribute("dataWindow", "box2i", window) +
           attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", little(0x3f800000, 4)) + attribute("screenWindowCenter", "v2f", little(0, 8)) +
           attribute("screenWindowWidth", "float", little(0x3f800000, 4)) + '\0' + little(400, 8) + std::string(90'000, '\1');
}

/// A Babylon.js environment of which all faces of all levels are one blank picture.
std::string env(int width, const std::string& png)
{
    std::string entries;
    for (int edge = width; edge > 0; edge /= 2)
        for (int face = 0; face < 6; ++face)
            entries += (entries.empty() ? "" : ",") + (R"({"position":0,"length":)" + std::to_string(png.size()) + "}");
    return "\x86\x16\x87\x96\xF6\xD6\x96\x36" + (R"({"version":2,"width":)" + std::to_string(width)) + R"(,"specular":{"mipmaps":[)" +
           entries + "]}}" + '\0' + png;
}

struct Hostile {
    const char* name;
    std::string bytes;
    const char* word;
};

void expectRefusal(const LimitedRun& run, const std::string& name, const std::string& word)
{
    EXPECT_EQ(run.status, 2) << name << ": " << run.err;
    EXPECT_EQ(test::lines(run.err), 1u) << name << ": " << run.err;
    EXPECT_NE(run.err.find(word), std::string::npos) << name << ": " << run.err;
    EXPECT_LT(run.bytes, mostMemory) << name;
}

TEST(ForeignFiles, HostileOnesCostLittleAndGiveOneLine)
{
    const TemporaryFolder folder;
    const std::string dpx = "SDPX" + std::string(2044, '\x7f'), iff = "FOR4" + big(456) + "CIMG" + std::string(452, '\x41');
    for (const Hostile& file : {Hostile{"dpx.hdr", dpx, "no image of a known format"},
                                Hostile{"row.hdr", "#?RADIANCE\n\n-Y 1 +X 259153249\n12345678", "row.hdr"}, Hostile{"dpx.png", dpx, ".png"},
                                Hostile{"a.iff", iff, "no image of a known format"}, Hostile{"a.psd", psd(30000, 30000), "a.psd"},
                                Hostile{"wide.psd", psd(200000, 1000), "wide.psd"}, Hostile{"a.ply", endlessPly(), "a.ply"},
                                Hostile{"a.webp", "RIFF" + std::string(4, '\xff') + "WEBPVP8L" + std::string(300, '\xff'), "a.webp"},
                                Hostile{"a.tif", std::string("II*\0\x08\0\0\0\xff\xff", 10) + std::string(4000, '\x11'), "a.tif"},
                                Hostile{"a.heic", std::string("\0\0\0\x18", 4) + "ftypheic" + std::string(900, '\x7f'), "a.heic"}}) {
        test::writeBytes(folder / file.name, file.bytes);
        expectRefusal(limited({"info", (folder / file.name).string()}, folder), file.name, file.word);
    }
}

// Headers that promise much in files of less than 100 kB: what a reader takes is bounded by what the file holds.
TEST(ForeignFiles, HeadersThatPromiseMuchTakeLittle)
{
    const TemporaryFolder folder;
    std::string
        gltf =
            R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":60000}],"bufferViews":[{"buffer":0,"byteLength":60000}],)"
            R"("meshes":[{"primitives":[)",
        accessors;
    for (int i = 0; i < 600; ++i) { // each unpacked to 60 000 floats
        gltf += (i == 0 ? "" : ",") + (R"({"attributes":{"POSITION":)" + std::to_string(i)) + "}}";
        accessors += (i == 0 ? "" : ",") + std::string(R"({"bufferView":0,"componentType":5120,"count":20000,"type":"VEC3"})");
    }
    gltf += R"(]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0,"accessors":[)" + accessors + "]}";
    test::writeBytes(folder / "a.bin", std::string(60'000, '\0'));
    for (const Hostile& file : {Hostile{"vertices.off", "OFF\n4000000000 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "cut short"},
                                Hostile{"faces.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "cut short"},
                                Hostile{"dwab.exr", exr(1 << 24, 1, 9), "dwab.exr"}, Hostile{"piz.exr", exr(1 << 22, 1, 4), "piz.exr"},
                                Hostile{"large.exr", exr(16384, 8192, 8), "large.exr"}, Hostile{"long.exr", exr(1, 1 << 24, 3), "long.exr"},
                                Hostile{"wide.env", env(8192, "\x89PNG\r\n\x1a\n" + std::string(900, '\1')), "8192 x 49152"},
                                Hostile{"many.gltf", gltf, "many.gltf"}}) {
        test::writeBytes(folder / file.name, file.bytes);
        expectRefusal(limited({"info", (folder / file.name).string()}, folder), file.name, file.word);
    }
}

/// A .ktx2 file of RGBA16F texels whose only level is this Zstandard frame. @param claimed  the size of the level, unpacked
std::string ktx2(const std::string& frame, std::uint64_t claimed, std::uint32_t edge = 1)
{
    return "\xABKTX 20\xBB\r\n\x1A\n" + little(97, 4) + little(2, 4) + little(edge, 4) + little(edge, 4) + little(0, 8) + little(1, 4) +
           little(1, 4) + little(2, 4) + std::string(32, '\0') + little(104, 8) + little(frame.size(), 8) + little(claimed, 8) + frame;
}

// What is packed inside of textures is unpacked in the helper, no further than the texture asks for.
TEST(ForeignFiles, PackedTexturesThatUnpackToMuchTakeLittle)
{
    const TemporaryFolder folder;
    const std::string start("\x28\xb5\x2f\xfd", 4), block("\x02\x00\x10\x00", 4); // RFC 8878: 2^17 times one byte
    std::string bomb = start + std::string("\x00\x38", 2), sized = start + "\xc0\x38" + little(std::uint64_t{1} << 30, 8);
    for (int i = 0; i < 1 << 13; ++i)
        for (std::string* frame : {&bomb, &sized})
            *frame += block;
    const std::string ihdr = "IHDR" + big(30000) + big(30000) + std::string("\x08\x06\0\0\0", 5);
    const auto crc = static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(ihdr.data()), static_cast<uInt>(ihdr.size())));
    for (const Hostile& file :
         {Hostile{"bomb.ktx2", ktx2(bomb, 8), "longer than its size asks for"}, Hostile{"sized.ktx2", ktx2(sized, 8), "sized.ktx2"},
          Hostile{"claims.ktx2", ktx2(sized, std::uint64_t{1} << 30), "claims.ktx2"},
          Hostile{"window.ktx2", ktx2(start + std::string("\x00\xa0", 2) + block, 8), "cannot be decompressed"},
          Hostile{"cut.ktx2", ktx2(bomb.substr(0, 3000), std::uint64_t{8} << 24, 4096), "shorter than its size asks for"},
          Hostile{"empty.ktx2", ktx2("", 8), "shorter than its size asks for"},
          Hostile{"bomb.env", env(64, "\x89PNG\r\n\x1a\n" + big(13) + ihdr + big(crc) + big(5000) + "IDAT" + std::string(5004, '\0')),
                  "claims 30000 x 30000"}}) {
        test::writeBytes(folder / file.name, file.bytes);
        expectRefusal(limited({"info", (folder / file.name).string()}, folder), file.name, file.word);
    }
}

// A program that stands alone: what it reads itself it reads, and for the rest it says what is missing.
TEST(ForeignFiles, WithoutItsHelperAProgramReadsNothingPacked)
{
    const TemporaryFolder folder;
    const std::filesystem::path program = folder / "mirrorball";
    std::filesystem::copy_file(MIRRORBALL_PROGRAM, program);
    const std::string frame("\x28\xb5\x2f\xfd\x20\x08\x41\x00\x00" // a block of eight bytes as they are: the texel 1, 1, 1
                            "\x00\x3c\x00\x3c\x00\x3c\x00\x3c",
                            17);
    std::string plain = ktx2(frame.substr(9), 8);
    plain[44] = 0; // no compression
    test::writeBytes(folder / "plain.ktx2", plain);
    test::writeBytes(folder / "packed.ktx2", ktx2(frame, 8));
    test::writeBytes(folder / "a.env", env(1, "\x89PNG\r\n\x1a\n"));
    const auto runs = [&](const std::string& with, const char* name) {
        const std::string command =
            with + " info " + (folder / name).string() + " >/dev/null 2>" + (folder / "err").string() + " </dev/null";
        const int result = std::system(command.c_str());
        return test::ProgramRun{WIFEXITED(result) ? WEXITSTATUS(result) : 255, "", test::readBytes(folder / "err")};
    };
    EXPECT_EQ(runs(MIRRORBALL_PROGRAM, "packed.ktx2").status, 0) << test::readBytes(folder / "err");
    EXPECT_EQ(runs(program.string(), "plain.ktx2").status, 0) << test::readBytes(folder / "err");
    for (const char* name : {"packed.ktx2", "a.env"}) {
        const test::ProgramRun run = runs(program.string(), name);
        if (run.status == 0)
            GTEST_SKIP() << "a helper is installed on this machine";
        EXPECT_FAILS(run, 1, "mirrorball-helper, which is not installed");
    }
}

// The same of users' reports beside the checkout.
TEST(ForeignFiles, HostileReportsCostLittleAndGiveOneLine)
{
    const TemporaryFolder folder;
    const std::filesystem::path reports = std::filesystem::path(MIRRORBALL_SHARED_DATA) / "../reports";
    if (!std::filesystem::exists(reports))
        GTEST_SKIP() << reports << " is not there";
    for (const char* name : {"abort_dpx_named.hdr", "segv_iff_1.iff", "3.7GB_10s.psd", "spin_1.ply"})
        expectRefusal(limited({"info", (reports / name).string()}, folder), name, name);
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
    const LimitedRun run = limited({"info", (folder / "blank.png").string()}, folder);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("8192 x 8192"), std::string::npos) << run.err;
    EXPECT_LT(run.bytes, mostMemory);
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
