#include "run_times.h"

#include <algorithm>
#include <cmath>

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

int repeats(int times, double limit, double seconds)
{
    if (times < 1)
        return 0;
    return static_cast<int>(std::clamp(std::ceil(limit / std::max(seconds, 1e-9)), 1.0, static_cast<double>(times)));
}

} // namespace mirrorball
