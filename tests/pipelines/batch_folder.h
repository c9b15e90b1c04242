#pragma once

#include "program.h"

#include "support/temporary_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball::test {

/// A folder with a small probe and a jobs file, and the program called in it.
class BatchFolder {
public:
    BatchFolder() { run("convert builtin:studio -o probe.hdr --to latlong --size 16"); }

    std::filesystem::path operator/(const std::string& name) const { return m_folder / name; }

    /// The program with these words, called in the folder.
    ProgramRun run(const std::string& words) const { return shell("$mirrorball " + words); }
    /// A line of a shell, in which $mirrorball is the program.
    ProgramRun shell(const std::string& line) const
    {
        const TemporaryFolder output;
        const std::string whole = "cd " + m_folder.path().string() + " && mirrorball=" MIRRORBALL_PROGRAM " && { " + line + "; } >" +
                                  (output / "out").string() + " 2>" + (output / "err").string() + " </dev/null";
        const int result = std::system(("bash -c '" + whole + "'").c_str());
        return {WIFEXITED(result) ? WEXITSTATUS(result) : 255, readBytes(output / "out"), readBytes(output / "err")};
    }
    void writeJobs(const std::string& jobs) const { writeBytes(m_folder / "jobs.json", R"({"version": 1, )" + jobs + "}"); }
    std::string bytes(const std::string& file) const { return readBytes(m_folder / file); }
    bool has(const std::string& file) const { return std::filesystem::exists(m_folder / file); }
    /// Names that begin with a dot: what was left half done.
    std::vector<std::string> leftovers() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path()))
            if (entry.path().filename().string().starts_with('.'))
                names.push_back(entry.path().filename().string());
        return names;
    }

private:
    TemporaryFolder m_folder{};
};

/// How many lines begin so.
inline size_t linesWith(const std::string& text, const std::string& beginning)
{
    size_t count = 0;
    for (size_t at = 0; at < text.size();) {
        count += text.compare(at, beginning.size(), beginning) == 0;
        const size_t end = text.find('\n', at);
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return count;
}

/// Three maps of the folder's probe.
inline const std::string threeMaps =
    R"("jobs": [{"command": ["filter", "probe.hdr", "-o", "maps/p#.exr", "--lobe", "phong", "--exponent", "#0", "--to", "cube", "--size", "8"], "frames": "1-3"}])";
inline std::string mapCommand(int i, const std::string& out)
{
    return "filter probe.hdr -o " + out + " --lobe phong --exponent " + std::to_string(i) + "0 --to cube --size 8";
}

} // namespace mirrorball::test
