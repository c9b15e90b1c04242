#include "command.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/export_estimate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include <sys/resource.h>

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

MapTarget parseTarget(const std::string& to, int size, int border)
{
    MapTarget target{.layout = {.kind = parseKind("--to", to), .size = size, .border = border}};
    if (target.layout.kind == Parameterization::Cube)
        target.faceBorder = std::exchange(target.layout.border, 0);
    validate(target.layout);
    if (target.faceBorder < 0 || target.faceBorder > size)
        throw InvalidArgument("--border: must lie between 0 and --size for a cube; it is " + std::to_string(border));
    return target;
}

namespace {

std::string shown(double number)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", number);
    return text.data();
}

/// What `isRight` refuses is answered with what the number must be.
CLI::Validator numbers(std::function<bool(double)> isRight, const std::string& must)
{
    return CLI::Validator(
        [isRight = std::move(isRight), must](std::string& typed) {
            double number = 0.0;
            const bool isNumber = CLI::detail::lexical_cast(typed, number);
            return isNumber && isRight(number) ? std::string() : "must be " + must + "; it is " + typed;
        },
        "");
}

} // namespace

CLI::Validator within(double low, double high)
{
    return numbers([=](double n) { return n >= low && n <= high; }, "a number from " + shown(low) + " to " + shown(high));
}

CLI::Validator above(double low, double high)
{
    return numbers([=](double n) { return n > low && n <= high; }, "a number above " + shown(low) + " and up to " + shown(high));
}

CLI::Validator anAngle() { return within(-360000.0, 360000.0); }
CLI::Validator aThreadCount() { return within(0, 1024); }
CLI::Validator anEdge() { return within(1, 65536); }

void refuseInfinities(CLI::App& program)
{
    for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        for (CLI::Option* option : command->get_options())
            if (option->get_type_name().find("FLOAT") != std::string::npos)
                option->check(numbers([](double n) { return std::isfinite(n); }, "a finite number"));
}

void checkOutputsDiffer(const std::vector<NamedOutput>& outputs)
{
    std::map<std::filesystem::path, std::string> seen;
    for (const NamedOutput& output : outputs)
        for (const std::filesystem::path& file : output.files) {
            std::error_code ignored;
            const auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(file), ignored);
            const auto [first, isNew] = seen.emplace(place, output.option);
            if (!isNew)
                throw InvalidArgument(output.option + ": " + file.string() + " is " +
                                      (first->second == output.option ? "named twice" : "what " + first->second + " writes, too") +
                                      "; give each output a name of its own");
        }
}

void writeStats(const std::filesystem::path& path, const std::vector<Stage>& plan, const WorkRecord& work, int threads)
{
    nlohmann::json stages = nlohmann::json::array();
    const auto add = [&](const Stage& stage) {
        stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"left_out", stage.leftOut}, {"why", stage.why}});
    };
    std::for_each(work.stages.begin(), work.stages.end(), add);
    for (const Stage& stage : plan)
        if (stage.leftOut)
            add(stage);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const nlohmann::json record{{"stages", stages},
                                {"method", work.methods.empty() ? "lookup" : work.methodText()},
                                {"band_limit", work.bandLimit},
                                {"predicted_error", work.predicted.relRms},
                                {"predicted_rel_rms", work.predicted.relRms},
                                {"predicted_median_rel", work.predicted.medianRel},
                                {"predicted_p99_rel", work.predicted.p99Rel},
                                {"promised", work.unpromised.empty()},
                                {"not_promised", work.unpromised},
                                {"threads", threads},
                                {"peak_bytes", static_cast<std::int64_t>(usage.ru_maxrss) * 1024}};
    const std::string text = record.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

void sayUnpromised(const std::string& command, const WorkRecord& record)
{
    for (const std::string& map : record.unpromised)
        std::cerr << command << ": " << map << '\n';
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

} // namespace mirrorball::cli
