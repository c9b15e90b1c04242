// What core/base/temporary_path promises where several processes and machines write into one folder.
#include "core/base/atomic_file.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

void write(const std::filesystem::path& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

/// A process looks for what dead ones left, when it comes to a folder first; a name that another one has just made and not locked yet looks
/// like that. Some hundred starts are enough to see a loss, if there can be any.
TEST(SharedFolder, ProcessesThatStartAtOnceLoseNothing)
{
    const TemporaryFolder folder;
    int lost = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<pid_t> processes;
        for (int i = 0; i < 8; ++i) {
            const pid_t process = ::fork();
            if (process == 0) {
                int status = 0;
                try {
                    write(folder / ("f" + std::to_string(i)), "x"); // the process is new to the folder
                } catch (...) {
                    status = 1;
                }
                ::_exit(status);
            }
            processes.push_back(process);
        }
        for (const pid_t process : processes) {
            int status = 0;
            ::waitpid(process, &status, 0);
            lost += status != 0;
        }
    }
    EXPECT_EQ(lost, 0);
}

/// A share need not show the locks of another machine, so a file of another one may be in use however it looks; a week later it is not.
TEST(SharedFolder, LeavesWhatAnotherMachineMayUse)
{
    const TemporaryFolder folder;
    const auto fresh = folder / ".a.mirrorball-tmp1234567-1-0", old = folder / ".b.mirrorball-tmp1234567-1-0";
    test::writeBytes(fresh, "x");
    test::writeBytes(old, "x");
    std::filesystem::last_write_time(old, std::filesystem::file_time_type::clock::now() - std::chrono::hours(24 * 8));
    write(folder / "c", "x");
    EXPECT_TRUE(std::filesystem::exists(fresh));
    EXPECT_FALSE(std::filesystem::exists(old));
}

} // namespace
} // namespace mirrorball
