#pragma once

#include "core/base/content_hash.h"
#include "core/base/fields.h"
#include "core/base/file_log.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How a file was made: the version of the program, the command, and the content of every file that it read and wrote. Written beside the
/// output when the output is whole, so that whoever finds both knows that the work is done, and whether it would be the same today.
namespace mirrorball {

/// The length of a file, a whole number in JSON.
struct ByteCount {
    std::uint64_t bytes = 0;
    bool operator==(const ByteCount&) const = default;
};
void readJson(const std::string& path, const nlohmann::json& json, ByteCount& value);
nlohmann::ordered_json writeJson(const ByteCount& value);

/// A file of a recipe.
struct RecipeFile {
    std::string file{}; ///< from the folder where the command ran, or absolute
    ByteCount bytes{};
    std::string sha256{}; ///< of its content, 64 hexadecimal digits
    UnknownKeys unknown{};

    template <typename Self, typename Visit>
    static void visitFields(Self& file, Visit&& visit)
    {
        visit(Field{"file", "from the folder where the command ran, or absolute"}, file.file);
        visit(Field{"bytes", "length"}, file.bytes);
        visit(Field{"sha256", "of the content"}, file.sha256);
    }
};

struct Recipe {
    std::string version{};              ///< of the program
    std::vector<std::string> command{}; ///< its words, without the program's name; what cannot change a byte of the output is left out
    std::string folder{};               ///< where it ran, from the folder of the recipe, or absolute
    std::vector<RecipeFile> inputs{}, outputs{};
    std::string recipe{}; ///< hash()
    UnknownKeys unknown{};

    template <typename Self, typename Visit>
    static void visitFields(Self& recipe, Visit&& visit)
    {
        visit(Field{"version", "of the program"}, recipe.version);
        visit(Field{"command", "words, without the program's name", 0, 1e6}, recipe.command);
        visit(Field{"folder", "where the command ran"}, recipe.folder);
        visit(Field{"inputs", "files that were read", 0, 1e6}, recipe.inputs);
        visit(Field{"outputs", "files that were written", 0, 1e6}, recipe.outputs);
        visit(Field{"recipe", "SHA-256 of version, command and inputs"}, recipe.recipe);
    }

    /// SHA-256 over the version, the command and the inputs' names and content: what the output follows from.
    std::string hash() const;
};

/// "OUT.recipe.json" beside what `-o OUT` names: a file, a folder, or a name with marks for faces and levels.
std::filesystem::path recipePath(const std::filesystem::path& output);

/// The recipe of a command that is done, by the log of its files. Reads all of them for their hashes.
/// @param folder  where the command ran
/// @throws WorkError where an input has changed since it was opened, is an output too, or nothing was written
Recipe makeRecipe(const std::string& version, const std::vector<std::string>& command, const std::filesystem::path& folder,
                  const FileLog& log);

/// Writes it beside `output`, whole or not at all. @throws WorkError
void saveRecipe(Recipe recipe, const std::filesystem::path& folder, const std::filesystem::path& output);

/// A recipe and where its command ran.
struct FoundRecipe {
    Recipe recipe{};
    std::filesystem::path folder{};
};
/// @throws FileError where the file is missing or damaged
FoundRecipe loadRecipe(const std::filesystem::path& recipeFile);
/// The recipe that made `output`: its own, that of a folder above it, or one of its folder that names it.
/// @throws FileError that says where one was looked for
FoundRecipe findRecipe(const std::filesystem::path& output);

/// Whether files are what recipes say. Each file is read once, however many recipes name it.
class RecipeChecker {
public:
    explicit RecipeChecker(std::string version) : m_version(std::move(version)) {}

    /// Why the outputs of `command` (run in `folder`, with `-o output`) would have to be made: empty where they are there, whole, and what
    /// this version makes of today's inputs.
    std::string whyToMake(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::filesystem::path& output);
    /// Why a recipe's files are no longer what it says; empty where they are.
    std::string whyStale(const FoundRecipe& found);

private:
    std::string difference(const RecipeFile& file, const std::filesystem::path& folder);

    struct Known {
        FileStamp stamp;
        FileContent content;
    };
    std::string m_version;
    std::map<std::filesystem::path, Known> m_known{};
};

} // namespace mirrorball
