#include "reference_command.h"

#include "command_words.h"
#include "scene_file_page.h"

#include "core/base/atomic_file.h"

#include <filesystem>
#include <memory>

namespace mirrorball::cli {
namespace {

void writeText(const std::filesystem::path& path, const std::string& text)
{
    std::filesystem::create_directories(path.parent_path());
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace

void addReferenceCommand(CLI::App& program)
{
    const auto folder = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("reference", "Write man pages and completions as an installation has them");
    command->group(""); // for whoever makes a package: not shown
    command->add_option("FOLDER", *folder, "gets man/ and completions/")->required();
    command->callback([folder, &program] {
        const std::filesystem::path whole(*folder);
        for (const ManPage& page : manPages(program, MIRRORBALL_VERSION))
            writeText(whole / "man" / page.file, page.text);
        writeText(whole / "completions/mirrorball", bashCompletion(program));
        writeText(whole / "completions/_mirrorball", zshCompletion(program));
        writeText(whole / "completions/mirrorball.fish", fishCompletion(program));
        writeText(whole / "scene-file.md", sceneFilePage());
    });
}

} // namespace mirrorball::cli
