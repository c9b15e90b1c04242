#include "lookup_table.h"

#include "engine_lookups.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

double viewAt(int column, int columns) { return std::acos((column + 0.5) / columns); }

void put(Image& table, int column, const LookupFit& fit)
{
    for (size_t k = 0; k < fit.lookups.size(); ++k) {
        const BrdfLookup& lookup = fit.lookups[k];
        float *place = table.texel(column, static_cast<int>(2 * k)), *weight = table.texel(column, static_cast<int>(2 * k + 1));
        place[0] = static_cast<float>(lookup.offset);
        place[1] = static_cast<float>(lookup.alpha);
        place[2] = static_cast<float>(lookup.turn);
        for (int c = 0; c < 3; ++c)
            weight[c] = static_cast<float>(lookup.weight[c]);
    }
}

} // namespace

LookupFit lookupsFor(const Brdf& brdf, double view, const LookupChoice& choice)
{
    switch (choice.kind) {
    case LookupKind::SplitSum:
        return splitSum(brdf, view);
    case LookupKind::Three:
        return threeLookups(engineMaterial(brdf), view);
    case LookupKind::Filament:
        return filamentLookups(engineMaterial(brdf), view);
    case LookupKind::Exact:
        throw InvalidArgument("lookups: what is exact has none");
    case LookupKind::Fitted:
        break;
    }
    return fitLookups(brdf, view, choice.count);
}

Image makeLookupTable(const Brdf& brdf, const LookupChoice& choice, int size, const JobControl& job)
{
    const int columns = size > 0 ? size : 32;
    std::vector<double> views;
    for (int i = 0; i < columns; ++i)
        views.push_back(viewAt(i, columns));
    std::vector<LookupFit> fits(views.size());
    if (choice.kind == LookupKind::Fitted)
        fits = fitLookups(brdf, views, choice.count, job);
    else
        parallelRows(
            columns, job,
            [&](int first, int last) {
                for (int i = first; i < last; ++i)
                    fits[static_cast<size_t>(i)] = lookupsFor(brdf, views[static_cast<size_t>(i)], choice);
            },
            1);
    Image table(columns, 2 * static_cast<int>(fits[0].lookups.size()));
    for (int i = 0; i < columns; ++i)
        put(table, i, fits[static_cast<size_t>(i)]);
    return table;
}

LookupFit lookupsAt(const Image& table, double view)
{
    const double x = std::clamp(std::cos(view) * table.width - 0.5, 0.0, table.width - 1.0);
    const int left = static_cast<int>(x), right = std::min(left + 1, table.width - 1);
    const double t = x - left;
    LookupFit fit{.view = view};
    for (int k = 0; 2 * k + 1 < table.height; ++k) {
        const auto read = [&](int row, int c) {
            return (1.0 - t) * static_cast<double>(table.texel(left, row)[c]) + t * static_cast<double>(table.texel(right, row)[c]);
        };
        fit.lookups.push_back(
            {read(2 * k, 0), read(2 * k, 1), {read(2 * k + 1, 0), read(2 * k + 1, 1), read(2 * k + 1, 2)}, read(2 * k, 2)});
    }
    return fit;
}

} // namespace mirrorball
