#include "progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include <unistd.h>

namespace mirrorball::cli {
namespace {

enum class ProgressStyle { Bar, Plain, OpenJobDescription, None };

/// Of the process, as its stderr and stdout are.
ProgressStyle& progressStyle()
{
    static ProgressStyle style = ProgressStyle::Bar;
    return style;
}

using Clock = std::chrono::steady_clock;

/// Draws "label [=====     ] 50%" over one line of stderr; clears it when it goes.
class ProgressBar {
public:
    explicit ProgressBar(std::string label) : m_label(std::move(label)) {}
    ~ProgressBar()
    {
        if (m_shown)
            std::fprintf(stderr, "\r\033[K");
    }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(float fraction)
    {
        using namespace std::chrono;
        const auto now = Clock::now();
        if (now - m_start < seconds(1) || now - m_last < milliseconds(50))
            return;
        m_last = now;
        m_shown = true;
        constexpr int length = 40;
        const int filled = static_cast<int>(static_cast<float>(length) * fraction);
        std::fprintf(stderr, "\r%s [%s%s] %3d%%", m_label.c_str(), std::string(static_cast<size_t>(filled), '=').c_str(),
                     std::string(static_cast<size_t>(length - filled), ' ').c_str(), static_cast<int>(100.0f * fraction));
    }

private:
    std::string m_label;
    Clock::time_point m_start = Clock::now(), m_last{};
    bool m_shown = false;
};

/// Prints whole percents as they grow.
class ProgressLines {
public:
    ProgressLines(std::string label, ProgressStyle style) : m_label(std::move(label)), m_style(style) {}
    ProgressLines(const ProgressLines&) = delete;
    ProgressLines& operator=(const ProgressLines&) = delete;
    /// The work is done, unless an error takes this object along.
    ~ProgressLines()
    {
        if (std::uncaught_exceptions() == m_exceptions)
            print(100);
    }

    void show(float fraction)
    {
        print(static_cast<int>(std::lround(99.0f * std::min(std::max(fraction, 0.0f), 1.0f)))); // files are still to be written at 1
    }

private:
    void print(int percent)
    {
        if (percent <= m_percent)
            return;
        if (m_style == ProgressStyle::OpenJobDescription) {
            std::printf("%.*s%d\n", static_cast<int>(openjdProgress.size()), openjdProgress.data(), percent);
            std::fflush(stdout);
        } else {
            const auto now = Clock::now();
            if (percent < 100 && now - m_last < std::chrono::seconds(1))
                return;
            m_last = now;
            std::fprintf(stderr, "%s: %d%%\n", m_label.c_str(), percent);
        }
        m_percent = percent;
    }

    std::string m_label;
    ProgressStyle m_style;
    Clock::time_point m_last = Clock::now();
    int m_percent = -1;
    int m_exceptions = std::uncaught_exceptions();
};

} // namespace

void addProgressOptions(CLI::App& program)
{
    for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        if (!command->get_option_no_throw("--threads") && !command->get_option_no_throw("--jobs"))
            continue;
        command
            ->add_option_function<std::string>(
                "--progress",
                [](const std::string& word) {
                    progressStyle() = word == "plain"    ? ProgressStyle::Plain
                                      : word == "openjd" ? ProgressStyle::OpenJobDescription
                                                         : ProgressStyle::None;
                },
                "plain: lines on stderr; openjd: lines on stdout for schedulers; none; without it a bar on a terminal")
            ->check(CLI::IsMember({"plain", "openjd", "none"}));
    }
}

std::function<void(float)> progressReport(const std::string& label)
{
    const ProgressStyle style = progressStyle();
    if (style == ProgressStyle::None || (style == ProgressStyle::Bar && isatty(STDERR_FILENO) == 0))
        return {};
    if (style == ProgressStyle::Bar)
        return [bar = std::make_shared<ProgressBar>(label)](float fraction) { bar->show(fraction); };
    return [lines = std::make_shared<ProgressLines>(label, style)](float fraction) { lines->show(fraction); };
}

JobControl jobWithProgress(const std::string& label, int threads)
{
    JobControl job{.threads = threads};
    job.progress = progressReport(label);
    return job;
}

} // namespace mirrorball::cli
