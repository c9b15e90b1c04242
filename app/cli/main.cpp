#include "command.h"
#include "recipe_option.h"
#include "reference_command.h"
#include "stopped.h"
#include "version_report.h"

#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/base/temporary_path.h"
#include "core/scene/scene_kinds.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace {

/// The one place where errors end: one line on stderr, and the exit status (docs/conventions.md).
int fail(const char* message, int status)
{
    std::fprintf(stderr, "mirrorball: %s\n", message);
    return status;
}

/// A caller may have closed a standard stream; the next file opened would take its number and its output. What stands in for stdout here
/// cannot be written, so that results that go nowhere are an error as ever.
void openStandardStreams()
{
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF)
            static_cast<void>(::open("/dev/null", number == STDERR_FILENO ? O_WRONLY : O_RDONLY)); // the lowest free number is this one
}

/// @throws WorkError when something that was printed did not arrive
void checkPrinted()
{
    errno = 0;
    std::cout.flush();
    const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
    if (failed)
        throw mirrorball::WorkError(std::string("stdout: cannot be written: ") +
                                    (errno != 0 ? std::strerror(errno) : "not all of it arrived") + "; free some space or print elsewhere");
}

/// CLI11 calls a command that it does not know a missing one. @throws InvalidArgument naming the known ones
void checkCommand(const CLI::App& program, int argc, char** argv)
{
    if (argc < 2 || argv[1][0] == '-')
        return;
    std::string known;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == argv[1])
            return;
        if (command->get_group().empty()) // not listed
            continue;
        known += (known.empty() ? "" : ", ") + command->get_name();
    }
    throw mirrorball::InvalidArgument("'" + std::string(argv[1]) + "' is no command; choose one of " + known);
}

} // namespace

int main(int argc, char** argv)
{
    using namespace mirrorball;
    openStandardStreams();
    removeTemporariesOnSignals();
    CLI::App program{"Materials with environment maps: convert, filter, render and export light probes.", "mirrorball"};
    bool verbose = false;
    program.add_flag("--verbose", verbose, "with --version: libraries, OpenGL, machine and limits, for bug reports");
    program.set_version_flag("--version", [&verbose] { return verbose ? cli::versionReport() : std::string(MIRRORBALL_VERSION); });
    program.require_subcommand(1);
    program.footer("PROBE is a file (.exr, .hdr, .tif, .png, ...) or builtin:NAME; `mirrorball presets` lists the names.\n"
                   "KIND is " +
                   field_json::listed(words(Parameterization{})) +
                   ".\n"
                   "Exit status: 0 done; 1 the work failed; 2 the arguments or the input are wrong; 75 batch was stopped, run it again.");
    cli::addCommands(program, argc, argv);
    cli::addProgressOptions(program);
    const cli::RecipeOption recipe(program);
    cli::addReferenceCommand(program);
    try {
        try {
            checkCommand(program, argc, argv);
            program.parse(argc, argv);
            recipe.write();
        } catch (const CLI::Success& e) { // --help, --version
            program.exit(e);
        }
        checkPrinted();
    } catch (const CLI::ParseError& e) {
        return fail((std::string(e.what()) + "; see mirrorball --help").c_str(), 2);
    } catch (const InvalidArgument& e) {
        return fail(e.what(), 2);
    } catch (const cli::Stopped& e) {
        return fail(e.what(), cli::Stopped::status);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory for this size", 1);
    } catch (const std::system_error& e) {
        return fail(e.code() == std::errc::resource_unavailable_try_again
                        ? "no thread can be started; allow more processes or memory, or give --threads 1"
                        : e.what(),
                    1);
    } catch (const std::exception& e) {
        return fail(e.what(), 1);
    }
    return 0;
}
