#include "core/batch/recipe.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <thread>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

void write(const std::filesystem::path& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

/// FIPS 180-4's examples.
TEST(ContentHash, IsSha256)
{
    EXPECT_EQ(contentHash("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(contentHash(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(contentHash(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    const TemporaryFolder folder;
    test::writeBytes(folder / "a", std::string(1'000'000, 'a'));
    EXPECT_EQ(fileContent(folder / "a"), (FileContent{1'000'000, contentHash(std::string(1'000'000, 'a'))}));
    EXPECT_THROW(fileContent(folder / "none"), FileError);
    EXPECT_THROW(fileContent(folder.path()), FileError);
}

TEST(FileLog, KnowsEveryFileOnceAndOnlyThoseOfItsLife)
{
    const TemporaryFolder folder;
    write(folder / "in", "input");
    noteRead(folder / "in");
    {
        const FileLog log;
        noteRead(folder / "in");
        noteRead(folder / "." / "in");
        noteRead(folder / "not there");
        write(folder / "out", "output");
        write(folder / "out", "output again");
        write(folder / "gone", "x");
        std::filesystem::remove(folder / "gone");
        ASSERT_EQ(log.read().size(), 1u);
        EXPECT_EQ(log.read().front().path, folder / "in");
        EXPECT_EQ(log.read().front().stamp.bytes, 5u);
        EXPECT_EQ(log.written(), std::vector<std::filesystem::path>{folder / "out"});
    }
    noteRead(folder / "out");
    EXPECT_TRUE(FileLog().read().empty());
}

/// A command `make -o out/map` that read `probe`, done in `folder`.
struct Done {
    std::filesystem::path folder;
    std::vector<std::string> command{"make", "probe", "--output", "out/map"};

    explicit Done(const std::filesystem::path& place) : folder(place)
    {
        std::filesystem::create_directories(folder / "out");
        write(folder / "probe", "radiance");
        const FileLog log;
        noteRead(folder / "probe");
        write(folder / "out/map", "texels");
        saveRecipe(makeRecipe("1.2", command, folder, log), folder, "out/map");
    }
    std::string why(const std::string& version = "1.2") const { return RecipeChecker(version).whyToMake(command, folder, "out/map"); }
};

TEST(Recipe, VerifiesWhatIsAsItWasMade)
{
    const TemporaryFolder folder;
    const Done done(folder.path());
    EXPECT_EQ(done.why(), "");
    std::filesystem::last_write_time(folder / "probe", std::filesystem::file_time_type::clock::now()); // dates do not count
    std::filesystem::last_write_time(folder / "out/map", std::filesystem::file_time_type::clock::now());
    EXPECT_EQ(done.why(), "");
}

TEST(Recipe, NoticesEveryDifference)
{
    const TemporaryFolder folder;
    const auto recipe = folder / "out/map.recipe.json";
    const auto expect = [&](const std::string& word, const std::function<void(Done&)>& harm, const std::string& version = "1.2") {
        Done done(folder.path());
        ASSERT_EQ(done.why(), "");
        harm(done);
        EXPECT_NE(done.why(version).find(word), std::string::npos) << word << ": " << done.why(version);
    };
    expect("out/map has changed", [&](Done&) { test::writeBytes(folder / "out/map", "texel"); });  // cut short
    expect("out/map has changed", [&](Done&) { test::writeBytes(folder / "out/map", "tExels"); }); // edited
    expect("out/map is missing", [&](Done&) { std::filesystem::remove(folder / "out/map"); });
    expect("probe has changed", [&](Done&) { test::writeBytes(folder / "probe", "Radiance"); });
    expect("probe is missing", [&](Done&) { std::filesystem::remove(folder / "probe"); });
    expect("no recipe", [&](Done&) { std::filesystem::remove(recipe); });
    expect("another command", [&](Done& done) { done.command[1] = "Probe"; });
    expect(
        "version 1.2", [&](Done&) {}, "1.3");
    expect("recipe.json: ", [&](Done&) { test::writeBytes(recipe, test::readBytes(recipe).substr(0, 100)); });
    // One who edits the input's hash in the recipe to fit another input has not made the output of it.
    expect("edited", [&](Done&) {
        test::writeBytes(folder / "probe", "Radiance");
        std::string text = test::readBytes(recipe);
        text.replace(text.find(contentHash("radiance")), 64, contentHash("Radiance"));
        test::writeBytes(recipe, text);
    });
    // A file that changes under one and the same checker is read again.
    Done done(folder.path());
    RecipeChecker checker("1.2");
    EXPECT_EQ(checker.whyToMake(done.command, done.folder, "out/map"), "");
    test::writeBytes(folder / "out/map", "tExels");
    EXPECT_NE(checker.whyToMake(done.command, done.folder, "out/map"), "");
}

TEST(Recipe, IsRefusedWhereItWouldNotBeTrue)
{
    const TemporaryFolder folder;
    write(folder / "probe", "radiance");
    {
        const FileLog log;
        noteRead(folder / "probe");
        write(folder / "map", "texels");
        write(folder / "probe", "Radiance"); // by whomever
        EXPECT_THROW(makeRecipe("1", {"make"}, folder.path(), log), WorkError);
    }
    {
        const FileLog log;
        noteRead(folder / "probe");
        write(folder / "map", "texels");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        test::writeBytes(folder / "probe", "rAdiance"); // in place, of the same length
        EXPECT_THROW(makeRecipe("1", {"make"}, folder.path(), log), WorkError);
    }
    const FileLog log;
    noteRead(folder / "probe");
    EXPECT_THROW(makeRecipe("1", {"make"}, folder.path(), log), WorkError); // nothing was written
}

TEST(Recipe, IsFoundByItsOutputs)
{
    const TemporaryFolder folder;
    const Done done(folder.path());
    std::filesystem::create_directories(folder / "game/faces");
    {
        const FileLog log;
        write(folder / "game/faces/a", "a");
        saveRecipe(makeRecipe("1", {"export"}, folder.path(), log), folder.path(), "game/");
    }
    {
        const FileLog log;
        write(folder / "x_px", "a");
        saveRecipe(makeRecipe("1", {"faces"}, folder.path(), log), folder.path(), "x_%s");
    }
    EXPECT_EQ(findRecipe(folder / "out/map").recipe.command, done.command);
    EXPECT_EQ(findRecipe(folder / "out/map").folder, folder.path());
    EXPECT_EQ(findRecipe(folder / "out/map.recipe.json").recipe.command, done.command);
    EXPECT_EQ(findRecipe(folder / "game").recipe.command.front(), "export");
    EXPECT_EQ(findRecipe(folder / "game/faces/a").recipe.command.front(), "export");
    EXPECT_EQ(findRecipe(folder / "x_px").recipe.command.front(), "faces");
    EXPECT_THROW(findRecipe(folder / "probe"), FileError);
    EXPECT_THROW(findRecipe(folder / "nothing"), FileError);
}

TEST(Recipe, HoldsAfterItsTreeWasMoved)
{
    const TemporaryFolder folder;
    Done done(folder / "here");
    std::filesystem::rename(folder / "here", folder / "there");
    done.folder = folder / "there";
    EXPECT_EQ(done.why(), "");
    EXPECT_EQ(findRecipe(folder / "there/out/map").folder, folder / "there");
    EXPECT_EQ(RecipeChecker("1.2").whyStale(findRecipe(folder / "there/out/map")), "");
}

} // namespace
} // namespace mirrorball
