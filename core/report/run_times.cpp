#include "run_times.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

double medianOf(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace

void RunTimes::add(const RunTime& run)
{
    seconds.push_back(run.wall);
    cpuSeconds.push_back(run.cpu);
}

double RunTimes::median() const { return medianOf(seconds); }

double RunTimes::cpuMedian() const { return medianOf(cpuSeconds); }

double RunTimes::shortest() const { return seconds.empty() ? 0.0 : *std::min_element(seconds.begin(), seconds.end()); }

double RunTimes::longest() const { return seconds.empty() ? 0.0 : *std::max_element(seconds.begin(), seconds.end()); }

RunTimes repeated(int times, double limit, const std::function<RunTime()>& run)
{
    RunTimes result;
    double spent = 0.0;
    for (int i = 0; i < times && (i == 0 || spent < limit); ++i) {
        result.add(run());
        spent += result.seconds.back();
    }
    return result;
}

int repeats(int times, double limit, double seconds)
{
    if (times < 1)
        return 0;
    return static_cast<int>(std::clamp(std::ceil(limit / std::max(seconds, 1e-9)), 1.0, static_cast<double>(times)));
}

} // namespace mirrorball
