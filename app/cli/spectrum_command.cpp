#include "command.h"
#include "reading_options.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/filter/spectrum_file.h"

#include <charconv>
#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, rows;
    ReadingOptions reading;
    std::vector<std::string> add;
    int degree = 256, threads = 0;
    double bright = 0.0;
};

RowRange parseRows(const std::string& text)
{
    RowRange rows;
    const char *at = text.data(), *end = at + text.size();
    const auto first = std::from_chars(at, end, rows.first);
    const bool hasColon = first.ec == std::errc() && first.ptr != end && *first.ptr == ':';
    const auto second = hasColon ? std::from_chars(first.ptr + 1, end, rows.end) : first;
    if (!hasColon || second.ec != std::errc() || second.ptr != end)
        throw InvalidArgument("--rows: must be A:B, the first row and the one behind the last, such as 0:1500; it is '" + text + "'");
    return rows;
}

void run(const Options& o)
{
    if (o.probe.empty() == o.add.empty())
        throw InvalidArgument(o.probe.empty() ? "PROBE: is missing; name a probe, or parts to add with --add"
                                              : "--add: given beside a probe; add parts in a call of its own");
    checkTarget(o.out);
    checkSpectrumName(o.out);
    const JobControl job = jobWithProgress("spectrum", o.threads);
    SpectrumPart part;
    if (!o.add.empty()) {
        std::vector<SpectrumPart> parts;
        for (const std::string& file : o.add)
            parts.push_back(readSpectrum(file));
        part = addSpectra(std::move(parts));
    } else {
        SpectrumOptions options{.degree = o.degree, .threshold = o.bright};
        if (!o.rows.empty())
            options.rows = parseRows(o.rows);
        ProbeFile probe(o.probe, {.reading = o.reading.parse()});
        part = probeSpectrum(probe, options, job);
    }
    writeSpectrum(o.out, part);
    if (part.repaired.nonFinite() > 0)
        std::fprintf(stderr, "mirrorball: note: %s\n", describe(part.repaired).c_str());
    if (!o.add.empty() && !part.isWhole())
        std::fprintf(stderr, "mirrorball: note: rows are missing, the first of them %d; filter takes the sum of all\n",
                     part.rows.front().first > 0 ? 0 : part.rows.front().end);
}

} // namespace

void addSpectrumCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "spectrum", "The spectrum of a probe too large for one machine: some of its rows at a time, added up, then taken by filter");
    command->add_option("PROBE", o->probe, "file of a latlong");
    command->add_option("-o,--output", o->out, "output file, such as part.spectrum")->required();
    command->add_option("--degree", o->degree, "band limit: lobes are filtered as far as their spectrum ends below it; 256")
        ->check(within(1, 2048));
    command
        ->add_option("--bright", o->bright,
                     "texels with a channel above this radiance are taken out and kept beside, as suns ask for; 0: none is")
        ->check(within(0, 1e30));
    command->add_option("--rows", o->rows, "A:B: only rows A to B - 1, for one task of many");
    command->add_option("--add", o->add, "files of parts, to be added up")->expected(1, 1 << 16);
    o->reading.addTo(*command);
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
