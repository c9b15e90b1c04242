#include "run_times.h"

#include <algorithm>

namespace mirrorball {

double RunTimes::median() const
{
    if (seconds.empty())
        return 0.0;
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    const size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

double RunTimes::shortest() const { return seconds.empty() ? 0.0 : *std::min_element(seconds.begin(), seconds.end()); }

double RunTimes::longest() const { return seconds.empty() ? 0.0 : *std::max_element(seconds.begin(), seconds.end()); }

RunTimes repeated(int times, double limit, const std::function<double()>& run)
{
    RunTimes result;
    double spent = 0.0;
    for (int i = 0; i < times && (i == 0 || spent < limit); ++i) {
        result.seconds.push_back(run());
        spent += result.seconds.back();
    }
    return result;
}

} // namespace mirrorball
