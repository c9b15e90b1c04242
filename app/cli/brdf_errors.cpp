#include "brdf_errors.h"

#include "command.h"
#include "reading_options.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/probe_file.h"
#include "core/report/brdf_errors.h"

#include <charconv>
#include <cstdio>
#include <filesystem>

namespace mirrorball::cli {

namespace {

std::vector<std::string> separated(const std::string& text)
{
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

std::vector<double> parseViews(const std::string& text)
{
    std::vector<double> views;
    for (const std::string& part : separated(text)) {
        double view = -1.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), view);
        if (error != std::errc() || end != part.data() + part.size() || !(view >= 0.0 && view < 90.0))
            throw InvalidArgument("--views: must be angles of at least 0 and below 90 degrees, such as 0,45,75; it is '" + text + "'");
        views.push_back(view);
    }
    return views;
}

std::vector<LookupChoice> parseLookups(const std::string& text)
{
    std::vector<LookupChoice> choices;
    for (const std::string& part : separated(text)) {
        const auto choice = lookupChoiceFromWord(part);
        if (!choice)
            throw InvalidArgument("--lookups: '" + part + "' is none; choose some of " + lookupChoiceHelp());
        choices.push_back(*choice);
    }
    return choices;
}

BrdfErrorOptions optionsOf(const BrdfErrorsRequest& request)
{
    BrdfErrorOptions options{.height = request.height};
    if (!request.views.empty())
        options.viewsDeg = parseViews(request.views);
    if (!request.lookups.empty())
        options.choices = parseLookups(request.lookups);
    return options;
}

std::string extensionOf(const std::string& path) { return std::filesystem::path(path).extension().string(); }

void writeText(const std::string& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace

void checkBrdfErrors(const BrdfErrorsRequest& request)
{
    optionsOf(request);
    std::vector<NamedOutput> outputs;
    for (const std::string& path : request.out) {
        const std::string extension = extensionOf(path);
        if (extension != ".csv" && extension != ".json" && extension != ".png")
            throw InvalidArgument("--output: '" + path + "' must end in .csv, .json or .png with --errors");
        checkTarget(path);
        outputs.push_back({"--output", filesOf(path)});
    }
    checkOutputsDiffer(outputs);
}

void printBrdfErrors(const BrdfErrorsRequest& request, const Brdf& brdf)
{
    const JobControl job = jobWithProgress("brdf", request.threads);
    const Probe probe = readProbe(request.probe, {.reading = request.reading}, partOf(job, 0.0f, 0.1f));
    printNotes(request.probe, probe.notes);
    const BrdfErrors errors = measureBrdfErrors(probe.map, brdf, optionsOf(request), partOf(job, 0.1f, 1.0f));
    std::fputs(brdfErrorsText(errors).c_str(), stdout);
    for (const std::string& path : request.out) {
        const std::string extension = extensionOf(path);
        if (extension == ".png")
            writeImage(path, brdfErrorsPicture(errors), {.encoding = Encoding::Display});
        else
            writeText(path, extension == ".csv" ? brdfErrorsCsv(errors) : brdfErrorsJson(errors));
    }
}

} // namespace mirrorball::cli
