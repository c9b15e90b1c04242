#include "command.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/export_estimate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
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
                                {"predicted_error", stats.predicted.relRms},
                                {"predicted_rel_rms", stats.predicted.relRms},
                                {"predicted_median_rel", stats.predicted.medianRel},
                                {"predicted_p99_rel", stats.predicted.p99Rel},
                                {"promised", stats.promised},
                                {"threads", stats.threads},
                                {"peak_bytes", static_cast<std::int64_t>(usage.ru_maxrss) * 1024}};
    const std::string text = record.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

namespace {

std::string timeText(double seconds)
{
    if (seconds < 0.9995)
        return std::to_string(std::max(1L, std::lround(seconds * 1e3))) + " ms";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f s", seconds);
    return text.data();
}

} // namespace

void printStages(const std::vector<Stage>& stages)
{
    const std::array<std::string, 5> heads{"stage", "", "time", "memory", "why"};
    std::vector<std::array<std::string, 5>> rows{heads};
    bool hasCosts = false;
    for (const Stage& stage : stages) {
        hasCosts = hasCosts || stage.expected != StageCost{};
        rows.push_back({stage.name, stage.leftOut ? "left out" : "needed",
                        stage.expected.seconds > 0.0 ? timeText(stage.expected.seconds) : "",
                        stage.expected.bytes > 0 ? byteText(stage.expected.bytes) : "", stage.why});
    }
    std::array<size_t, 5> widths{};
    for (const auto& row : rows)
        for (size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    const auto width = [&](size_t i) { return static_cast<int>(widths[i]); };
    for (const auto& row : rows) {
        std::printf("%-*s  %-*s  ", width(0), row[0].c_str(), width(1), row[1].c_str());
        if (hasCosts)
            std::printf("%*s  %*s  ", width(2), row[2].c_str(), width(3), row[3].c_str());
        std::printf("%s\n", row[4].c_str());
    }
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
