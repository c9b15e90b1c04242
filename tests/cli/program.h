#pragma once

#include "support/temporary_folder.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include <sys/wait.h>

namespace mirrorball::test {

/// What a run of the command line left: its exit status and what it printed.
struct ProgramRun {
    int status = 0;
    std::string out, err;
};

/// Runs the program with the words of `arguments`, through a shell as a user would. A crash gives a status above 128.
inline ProgramRun mirrorballRuns(const std::string& arguments)
{
    const TemporaryFolder folder;
    const std::string command =
        MIRRORBALL_PROGRAM " " + arguments + " >" + (folder / "out").string() + " 2>" + (folder / "err").string() + " </dev/null";
    const int result = std::system(command.c_str());
    return {WIFEXITED(result) ? WEXITSTATUS(result) : 255, readBytes(folder / "out"), readBytes(folder / "err")};
}

inline size_t lines(const std::string& text)
{
    size_t count = 0;
    for (const char c : text)
        count += c == '\n';
    return count;
}

} // namespace mirrorball::test

/// The run failed as docs/conventions.md promises: this status, one line on stderr that contains the word, nothing on stdout.
#define EXPECT_FAILS(run, expectedStatus, word)                                                                                            \
    do {                                                                                                                                   \
        const mirrorball::test::ProgramRun result_ = (run);                                                                                \
        EXPECT_EQ(result_.status, expectedStatus) << result_.err;                                                                          \
        EXPECT_EQ(mirrorball::test::lines(result_.err), 1u) << result_.err;                                                                \
        EXPECT_NE(result_.err.find(word), std::string::npos) << result_.err;                                                               \
        EXPECT_EQ(result_.out, "");                                                                                                        \
    } while (false)
