#include "core/base/atomic_file.h"

#include "core/base/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace mirrorball;
using test::TemporaryFolder;

namespace {

size_t entries(const std::filesystem::path& folder)
{
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator{}));
}

/// Runs `work` in a process of its own and returns how it ended, as waitpid() says.
template <class Work>
int inAnotherProcess(const Work& work)
{
    const pid_t process = ::fork();
    if (process == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    return status;
}

void write(const std::filesystem::path& path, const std::string& text, Durability durability = Durability::Buffered)
{
    AtomicFile file(path, durability);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace

TEST(AtomicFile, AppearsWholeOrNotAtAll)
{
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a");
        file.write("half", 4);
    }
    EXPECT_EQ(entries(folder.path()), 0u);
    for (const Durability durability : {Durability::Buffered, Durability::Synced}) {
        write(folder / "a", "whole", durability);
        EXPECT_EQ(test::readBytes(folder / "a"), "whole");
        EXPECT_EQ(entries(folder.path()), 1u);
    }
}

TEST(AtomicFile, KeepsPermissionsAndOwnerButNoRightsOfTheOwner)
{
    const TemporaryFolder folder;
    write(folder / "a", "old");
    ASSERT_EQ(::chmod((folder / "a").c_str(), 06741), 0);
    const bool isRoot = ::getuid() == 0;
    if (isRoot) {
        ASSERT_EQ(::chown((folder / "a").c_str(), 1234, 2345), 0);
    }
    ASSERT_EQ(::chmod((folder / "a").c_str(), 06741), 0);
    write(folder / "a", "new");
    struct stat now {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 07777, 0741u);
    if (isRoot) {
        EXPECT_EQ(now.st_uid, 1234u);
        EXPECT_EQ(now.st_gid, 2345u);
    }
}

TEST(AtomicFile, SignalsThatEndTheProcessLeaveNothingAndStillEndIt)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const TemporaryFolder folder;
        write(folder / "a", "old");
        const int status = inAnotherProcess([&] {
            removeTemporariesOnSignals();
            AtomicFile file(folder / "a");
            const TemporaryPath staging(folder / "b", TemporaryPath::Kind::Folder);
            write(staging.path() / "inside", "x");
            std::filesystem::create_directory(staging.path() / "deeper");
            write(staging.path() / "deeper" / "inside", "x");
            ::raise(signal);
        });
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(entries(folder.path()), 1u) << signal;
        EXPECT_EQ(test::readBytes(folder / "a"), "old");
    }
}

TEST(AtomicFile, SweepsWhatDeadProcessesLeftAndNothingElse)
{
    const TemporaryFolder folder;
    const TemporaryPath living(folder / "living", TemporaryPath::Kind::File);
    test::writeBytes(folder / ".mine.tmp", "x");
    test::writeBytes(folder / ".a.mirrorball-tmp12-x", "x");
    inAnotherProcess([&] {
        AtomicFile file(folder / "a");
        const TemporaryPath staging(folder / "b", TemporaryPath::Kind::Folder);
        test::writeBytes(staging.path() / "inside", "x");
        ::kill(::getpid(), SIGKILL);
    });
    EXPECT_EQ(entries(folder.path()), 5u);
    inAnotherProcess([&] { write(folder.path() / "." / "c", "new"); }); // a folder that this process has not looked at yet
    EXPECT_EQ(entries(folder.path()), 4u);
    EXPECT_TRUE(std::filesystem::exists(living.path()));
    EXPECT_TRUE(std::filesystem::exists(folder / ".mine.tmp"));
    EXPECT_EQ(test::readBytes(folder / "c"), "new");
}
