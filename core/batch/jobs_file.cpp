#include "jobs_file.h"

#include "frame_list.h"

#include "core/base/field_json.h"

#include <algorithm>

#include <glob.h>

namespace mirrorball {
namespace {

using namespace field_json;

constexpr size_t mostCommands = 1'000'000;

struct Job {
    std::vector<std::string> command{};
    std::string scene{}, picture{}, exports{}, frames{};
    std::vector<std::string> each{}, options{};
    UnknownKeys unknown{};

    template <typename Self, typename Visit>
    static void visitFields(Self& job, Visit&& visit)
    {
        visit(Field{"command", "words of a command line, without the program's name", 1, 10'000}, job.command);
        visit(Field{"scene", "scene file, in place of a command"}, job.scene);
        visit(Field{"picture", "of the scene: the picture to render"}, job.picture);
        visit(Field{"exports", "of the scene: the folder for its exports"}, job.exports);
        visit(Field{"options", "of the scene: further words of render or export", 0, 10'000}, job.options);
        visit(Field{"frames", "such as 1-24, 1-100x5 or 1-9,20"}, job.frames);
        visit(Field{"each", "files or patterns, one command for each", 0, 1e6}, job.each);
    }
};

struct Jobs {
    int perTask = 1;
    std::vector<Job> jobs{};
    UnknownKeys unknown{};

    template <typename Self, typename Visit>
    static void visitFields(Self& file, Visit&& visit)
    {
        visit(Field{"per_task", "commands that a task runs one after the other", 1, 1e6}, file.perTask);
        visit(Field{"jobs", "commands, or scenes with frames", 1, 1e6}, file.jobs);
    }
};

void refuseUnknown(const std::string& path, const UnknownKeys& unknown, const char* known)
{
    if (!unknown.empty())
        throw InvalidArgument(fieldPath(path, unknown.begin()->first) + ": is no field; choose one of " + known);
}

/// What the scene of a job is to become, as a command.
std::vector<std::string> sceneCommand(const std::string& path, const Job& job)
{
    if (job.picture.empty() == job.exports.empty())
        throw InvalidArgument(path + ": a scene needs one of picture (what to render to) and exports (a folder for its maps)");
    std::vector<std::string> words{job.picture.empty() ? "export" : "render", job.scene, "-o", job.picture + job.exports};
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

std::vector<std::string> wordsOf(const std::string& path, const Job& job)
{
    if (job.command.empty() == job.scene.empty())
        throw InvalidArgument(path + ": needs one of command (a list of words) and scene (a file)");
    if (!job.scene.empty())
        return sceneCommand(path, job);
    if (!job.picture.empty() || !job.exports.empty() || !job.options.empty())
        throw InvalidArgument(path + ": picture, exports and options belong to a scene; put them into command's own words");
    return job.command;
}

bool isPattern(const std::string& text) { return text.find_first_of("*?[") != std::string::npos; }

/// The files that a pattern fits, by name, as the pattern names them: from `folder` where it is relative.
std::vector<std::string> filesOf(const std::string& field, const std::string& pattern, const std::filesystem::path& folder)
{
    const bool isRelative = std::filesystem::path(pattern).is_relative();
    const std::filesystem::path whole = folder / pattern;
    std::error_code error;
    std::vector<std::string> files;
    if (!isPattern(pattern)) {
        if (std::filesystem::exists(whole, error))
            files.push_back(pattern);
    } else {
        std::string literal; // the folder's own name is no pattern
        for (const char c : folder.string())
            literal += std::string("*?[]\\").find(c) != std::string::npos ? std::string{'\\', c} : std::string(1, c);
        glob_t found{};
        if (::glob((isRelative ? literal + "/" + pattern : pattern).c_str(), 0, nullptr, &found) == 0)
            for (size_t i = 0; i < found.gl_pathc; ++i)
                files.emplace_back(isRelative ? std::filesystem::path(found.gl_pathv[i]).lexically_relative(folder).string()
                                              : std::string(found.gl_pathv[i]));
        ::globfree(&found);
        std::sort(files.begin(), files.end()); // by bytes: glob's order is the locale's
    }
    if (files.empty())
        throw InvalidArgument(field + ": no file fits " + inQuotes(pattern) + " in " + shownPath(folder.string()));
    return files;
}

void addForEach(std::vector<BatchCommand>& commands, const std::string& path, const Job& job, const BatchCommand& one,
                const std::filesystem::path& folder)
{
    const auto isNamed = [](const std::string& word) {
        return word.find("{path}") != std::string::npos || word.find("{stem}") != std::string::npos;
    };
    if (std::none_of(one.words.begin(), one.words.end(), isNamed))
        throw InvalidArgument(path + ".each: no word has {path} or {stem} in it, so every command would be the same");
    for (size_t i = 0; i < job.each.size(); ++i)
        for (const std::string& file : filesOf(path + ".each[" + std::to_string(i) + "]", job.each[i], folder)) {
            BatchCommand command{one.where + " for " + shownPath(file), one.words};
            for (std::string& word : command.words)
                word = replacedAll(replacedAll(std::move(word), "{stem}", std::filesystem::path(file).stem().string()), "{path}", file);
            commands.push_back(std::move(command));
        }
}

void addFrames(std::vector<BatchCommand>& commands, const std::string& path, const Job& job, const BatchCommand& one)
{
    std::vector<int> frames;
    try {
        frames = parseFrames(job.frames);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(path + ".frames: " + error.what());
    }
    if (std::none_of(one.words.begin(), one.words.end(), namesFrame))
        throw InvalidArgument(path + ".frames: no word has #### or {frame} in it, so every frame would be the same");
    for (const int frame : frames) {
        BatchCommand command{one.where + " for frame " + std::to_string(frame), {}};
        for (const std::string& word : one.words)
            command.words.push_back(withFrame(word, frame));
        commands.push_back(std::move(command));
    }
}

void add(std::vector<BatchCommand>& commands, const std::string& path, const Job& job, const std::filesystem::path& folder)
{
    refuseUnknown(path, job.unknown, "command, scene, picture, exports, options, frames, each");
    if (!job.frames.empty() && !job.each.empty())
        throw InvalidArgument(path + ": has both frames and each; give one of them");
    const BatchCommand one{path + (job.scene.empty() ? ".command" : ".scene"), wordsOf(path, job)};
    if (!job.each.empty())
        addForEach(commands, path, job, one, folder);
    else if (!job.frames.empty())
        addFrames(commands, path, job, one);
    else
        commands.push_back(one);
    if (commands.size() > mostCommands)
        throw InvalidArgument(path + ": makes more than " + std::to_string(mostCommands) + " commands; divide them over several files");
}

} // namespace

std::span<const BatchCommand> BatchFile::task(size_t number) const
{
    const size_t length = static_cast<size_t>(perTask), first = number * length;
    return std::span(commands).subspan(first, std::min(length, commands.size() - first));
}

BatchFile loadJobs(const std::filesystem::path& path)
{
    constexpr std::string_view what = "jobs file";
    return namingFile(path, [&] {
        const Json json = parse(readText(path, what), what);
        if (!json.is_object())
            refuse("the file", "an object in { } such as {\"version\": 1, \"jobs\": [...]}", json);
        checkVersion(json, 1, what);
        Jobs file;
        Reader reader("", json);
        Jobs::visitFields(file, reader);
        reader.known().emplace("version");
        refuseUnknown("", reader.unknownKeys(), "version, per_task, jobs");
        if (file.jobs.empty())
            throw InvalidArgument("jobs: is missing; list what to make, such as {\"command\": [\"filter\", ...]}");
        BatchFile batch{.folder = folderOf(path), .commands = {}, .perTask = file.perTask};
        for (size_t i = 0; i < file.jobs.size(); ++i)
            add(batch.commands, "jobs[" + std::to_string(i) + "]", file.jobs[i], batch.folder);
        return batch;
    });
}

} // namespace mirrorball
