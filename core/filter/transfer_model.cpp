#include "transfer_model.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

double TransferModel::relRms(const std::vector<double>& power) const
{
    double error = 0.0, total = 0.0;
    for (size_t l = 0; l < k.size(); ++l) {
        error += power[l] * (bias[l] * bias[l] + scatter[l]);
        total += power[l] * k[l] * k[l];
    }
    constexpr double floatLookups = 1e-7;
    return std::max(floatLookups, total > 0.0 ? std::sqrt(error / total) : 0.0);
}

} // namespace mirrorball
