#include "recipe.h"

#include "core/base/field_json.h"

#include <algorithm>
#include <system_error>

namespace mirrorball {
namespace {

using namespace field_json;

constexpr std::string_view ending = ".recipe.json";
constexpr std::string_view what = "recipe";

/// A path as a recipe keeps it: from `folder` where it lies in it, so that a tree can be moved as a whole.
std::string kept(const std::filesystem::path& path, const std::filesystem::path& folder) { return storedPath(path.string(), "/", folder); }

std::filesystem::path there(const std::string& file, const std::filesystem::path& folder) { return (folder / file).lexically_normal(); }

/// From the folder of the recipe to that of its command: the way there, unless it leads over links.
std::string wayTo(const std::filesystem::path& folder, const std::filesystem::path& from)
{
    std::error_code error;
    const std::string way = folder.lexically_relative(from).string();
    return std::filesystem::weakly_canonical(from / way, error) == std::filesystem::weakly_canonical(folder, error) && !error &&
                   !way.empty()
               ? way
               : folder.string();
}

RecipeFile described(const std::filesystem::path& path, const std::filesystem::path& folder)
{
    const FileContent content = fileContent(path);
    return {.file = kept(path, folder), .bytes = {content.bytes}, .sha256 = content.sha256};
}

std::filesystem::path withoutSlash(const std::filesystem::path& output) { return output.has_filename() ? output : output.parent_path(); }

std::filesystem::path folderAbove(const std::filesystem::path& path)
{
    return std::filesystem::absolute(path).lexically_normal().parent_path();
}

} // namespace

void readJson(const std::string& path, const nlohmann::json& json, ByteCount& value)
{
    if (!json.is_number_unsigned())
        refuse(path, "a whole number", json);
    value.bytes = json.get<std::uint64_t>();
}

nlohmann::ordered_json writeJson(const ByteCount& value) { return value.bytes; }

std::string Recipe::hash() const
{
    OrderedJson all{{"version", version}, {"command", command}, {"inputs", OrderedJson::array()}};
    for (const RecipeFile& input : inputs)
        all["inputs"].push_back({input.file, input.sha256});
    return contentHash(all.dump(-1, ' ', true, OrderedJson::error_handler_t::replace));
}

std::filesystem::path recipePath(const std::filesystem::path& output)
{
    std::filesystem::path path = withoutSlash(output);
    path += ending;
    return path;
}

Recipe makeRecipe(const std::string& version, const std::vector<std::string>& command, const std::filesystem::path& folder,
                  const FileLog& log)
{
    Recipe recipe{.version = version, .command = command};
    const std::vector<std::filesystem::path> written = log.written();
    if (written.empty())
        throw WorkError("--recipe: the command wrote no file; leave it out");
    for (const FileRead& input : log.read()) {
        if (std::find(written.begin(), written.end(), input.path) != written.end())
            throw WorkError(shownPath(input.path.string()) +
                            ": is read and written by one command, so that nothing can make it again; give the output a name of its own");
        recipe.inputs.push_back(described(input.path, folder));
        std::error_code missing;
        if (!std::filesystem::exists(input.path, missing) || fileStamp(input.path) != input.stamp)
            throw WorkError(shownPath(input.path.string()) + ": was changed while it was read; run the command again");
    }
    for (const std::filesystem::path& file : written)
        recipe.outputs.push_back(described(file, folder));
    const auto byName = [](const RecipeFile& a, const RecipeFile& b) { return a.file < b.file; }; // files may be opened in any order
    std::sort(recipe.inputs.begin(), recipe.inputs.end(), byName);
    std::sort(recipe.outputs.begin(), recipe.outputs.end(), byName);
    recipe.recipe = recipe.hash();
    return recipe;
}

void saveRecipe(Recipe recipe, const std::filesystem::path& folder, const std::filesystem::path& output)
{
    const std::filesystem::path place = recipePath(folder / output);
    recipe.folder = wayTo(folder, folderAbove(place));
    OrderedJson json = Writer::toJson(recipe);
    OrderedJson whole{{"mirrorball_recipe", 1}};
    whole.update(json);
    field_json::save(whole, place, what);
}

FoundRecipe loadRecipe(const std::filesystem::path& recipeFile)
{
    return namingFile(recipeFile, [&] {
        const Json json = parse(readText(recipeFile, what), what);
        FoundRecipe found;
        Reader reader("", json);
        Recipe::visitFields(found.recipe, reader);
        if (!json.contains("mirrorball_recipe") || json["mirrorball_recipe"] != 1)
            throw InvalidArgument("mirrorball_recipe: must be 1; this is no recipe, or one of a newer version");
        const std::filesystem::path way(found.recipe.folder);
        found.folder = (folderAbove(recipeFile) / way).lexically_normal();
        if (!found.folder.has_filename())
            found.folder = found.folder.parent_path();
        return found;
    });
}

FoundRecipe findRecipe(const std::filesystem::path& output)
{
    const std::filesystem::path whole = withoutSlash(std::filesystem::absolute(output).lexically_normal());
    const auto names = [&](const FoundRecipe& found) {
        return std::any_of(found.recipe.outputs.begin(), found.recipe.outputs.end(),
                           [&](const RecipeFile& file) { return there(file.file, found.folder) == whole; });
    };
    std::error_code error;
    if (whole.string().ends_with(ending) && std::filesystem::is_regular_file(whole, error))
        return loadRecipe(whole);
    for (std::filesystem::path place = whole; place != place.root_path(); place = place.parent_path())
        if (std::filesystem::is_regular_file(recipePath(place), error))
            if (const FoundRecipe found = loadRecipe(recipePath(place)); place == whole || names(found))
                return found;
    // The file of a face, a level, or of an option other than -o.
    for (const auto& entry : std::filesystem::directory_iterator(whole.parent_path(), error)) {
        if (!entry.path().string().ends_with(ending))
            continue;
        try {
            if (const FoundRecipe found = loadRecipe(entry.path()); names(found))
                return found;
        } catch (const FileError&) { // another file's, which is damaged
            continue;
        }
    }
    if (!std::filesystem::exists(whole, error))
        throw FileError(output.string(), "does not exist, and there is no recipe of it; check the path");
    throw FileError(output.string(),
                    "has no recipe: neither " + recipePath(whole.filename()).string() +
                        " nor another one in its folder or above names it; make it by `mirrorball batch` or with --recipe");
}

std::string RecipeChecker::difference(const RecipeFile& file, const std::filesystem::path& folder)
{
    const std::filesystem::path path = there(file.file, folder);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return shownPath(file.file) + " is missing";
    const FileStamp stamp = fileStamp(path);
    if (stamp.bytes != file.bytes.bytes)
        return shownPath(file.file) + " has changed";
    auto known = m_known.find(path);
    if (known == m_known.end() || known->second.stamp != stamp)
        known = m_known.insert_or_assign(path, Known{stamp, fileContent(path)}).first;
    return known->second.content.sha256 == file.sha256 ? "" : shownPath(file.file) + " has changed";
}

std::string RecipeChecker::whyStale(const FoundRecipe& found)
{
    const Recipe& recipe = found.recipe;
    if (recipe.hash() != recipe.recipe || recipe.outputs.empty())
        return "its recipe was edited";
    for (const std::vector<RecipeFile>* files : {&recipe.inputs, &recipe.outputs})
        for (const RecipeFile& file : *files)
            if (const std::string why = difference(file, found.folder); !why.empty())
                return why;
    return recipe.version == m_version ? "" : "it was made by version " + recipe.version + ", and this is " + m_version;
}

std::string RecipeChecker::whyToMake(const std::vector<std::string>& command, const std::filesystem::path& folder,
                                     const std::filesystem::path& output)
{
    const std::filesystem::path place = recipePath(folder / output);
    std::error_code error;
    if (!std::filesystem::exists(place, error))
        return std::filesystem::exists(folder / output, error) ? "it has no recipe" : "it is not there";
    try {
        FoundRecipe found = loadRecipe(place);
        if (found.recipe.command != command)
            return "its recipe is another command";
        found.folder = folder; // a tree that was moved as a whole is the same tree
        return whyStale(found);
    } catch (const FileError& damaged) {
        return damaged.what();
    }
}

} // namespace mirrorball
