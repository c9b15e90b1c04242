#include "command.h"

#include "core/atomic_file.h"
#include "core/error.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <memory>

#include <sys/resource.h>
#include <unistd.h>

namespace mirrorball::cli {

Parameterization parseKind(const std::string& option, const std::string& word)
{
    if (const auto kind = parameterizationFromName(word))
        return *kind;
    std::string known;
    for (const Parameterization p : allParameterizations)
        known += (known.empty() ? "" : ", ") + std::string(name(p));
    throw InvalidArgument(option + ": '" + word + "' is no parameterization; choose one of " + known);
}

void writeStats(const std::filesystem::path& path, const Stats& stats)
{
    nlohmann::json stages = nlohmann::json::array();
    for (const Stage& stage : stats.stages)
        stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"left_out", stage.leftOut}, {"why", stage.why}});
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const nlohmann::json record{{"stages", stages},
                                {"method", stats.method},
                                {"band_limit", stats.bandLimit},
                                {"predicted_error", stats.predictedError},
                                {"threads", stats.threads},
                                {"peak_bytes", static_cast<std::int64_t>(usage.ru_maxrss) * 1024}};
    const std::string text = record.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

void printStages(const std::vector<Stage>& stages)
{
    size_t widest = 0;
    for (const Stage& stage : stages)
        widest = std::max(widest, stage.name.size());
    for (const Stage& stage : stages)
        std::printf("%-*s  %-8s  %s\n", static_cast<int>(widest), stage.name.c_str(), stage.leftOut ? "left out" : "needed",
                    stage.why.c_str());
    std::fflush(stdout);
}

namespace {

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
        const auto now = steady_clock::now();
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
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now(), m_last{};
    bool m_shown = false;
};

} // namespace

JobControl jobWithProgress(const std::string& label, int threads)
{
    JobControl job{.threads = threads};
    if (isatty(STDERR_FILENO) != 0)
        job.progress = [bar = std::make_shared<ProgressBar>(label)](float fraction) { bar->show(fraction); };
    return job;
}

} // namespace mirrorball::cli
