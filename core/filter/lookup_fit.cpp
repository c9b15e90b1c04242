#include "brdf_lookups.h"

#include "lookup_products.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace mirrorball {

namespace {

constexpr size_t mostLookups = 8;

using Small = std::array<std::array<double, mostLookups>, mostLookups>;

/// Weights of n atoms that are not below 0, add up to 1 and leave least: by trying every subset, each by its normal equations.
struct Weights {
    std::array<double, mostLookups> w{};
    double cost = 1e300; ///< w.G w - 2 w.b, to which |K|^2 is added
};

/// Minimizes over the atoms of a subset with the sum fixed: [G 1; 1 0][w; mu] = [b; 1], by elimination.
bool solveSubset(const Small& gram, const std::array<double, mostLookups>& b, const std::vector<size_t>& atoms, Weights& out)
{
    const size_t n = atoms.size(), size = n + 1;
    std::array<std::array<double, mostLookups + 2>, mostLookups + 1> a{};
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j)
            a[i][j] = gram[atoms[i]][atoms[j]];
        a[i][i] *= 1.0 + 1e-9;
        a[i][n] = a[n][i] = 1.0;
        a[i][size] = b[atoms[i]];
    }
    a[n][size] = 1.0;
    for (size_t p = 0; p < size; ++p) {
        size_t best = p;
        for (size_t i = p + 1; i < size; ++i)
            if (std::abs(a[i][p]) > std::abs(a[best][p]))
                best = i;
        if (std::abs(a[best][p]) < 1e-14)
            return false;
        std::swap(a[p], a[best]);
        for (size_t i = 0; i < size; ++i)
            if (i != p) {
                const double factor = a[i][p] / a[p][p];
                for (size_t j = p; j <= size; ++j)
                    a[i][j] -= factor * a[p][j];
            }
    }
    out = {};
    for (size_t i = 0; i < n; ++i) {
        out.w[atoms[i]] = a[i][size] / a[i][i];
        if (out.w[atoms[i]] < 0.0)
            return false;
    }
    out.cost = 0.0;
    for (const size_t i : atoms) {
        out.cost -= 2.0 * out.w[i] * b[i];
        for (const size_t j : atoms)
            out.cost += out.w[i] * out.w[j] * gram[i][j];
    }
    return true;
}

Weights solve(const Small& gram, const std::array<double, mostLookups>& b, size_t n)
{
    Weights best;
    std::vector<size_t> atoms(n);
    for (size_t i = 0; i < n; ++i)
        atoms[i] = i;
    if (solveSubset(gram, b, atoms, best))
        return best; // the unconstrained optimum lies inside
    for (size_t subset = 1; subset < (size_t{1} << n); ++subset) {
        atoms.clear();
        for (size_t i = 0; i < n; ++i)
            if (subset >> i & 1)
                atoms.push_back(i);
        Weights tried;
        if (solveSubset(gram, b, atoms, tried) && tried.cost < best.cost)
            best = tried;
    }
    return best;
}

/// One lookup in the plane of incidence, or two beside it, one a side, that share their weight.
struct Group {
    double offset = 0.0, alpha = 0.1, turn = 0.0;
    bool isPair = false;
};

/// How many of the lookups stand in pairs. What a kernel is wide across the plane of incidence only pairs can follow; what it is long along
/// it, lookups one by one.
struct Pattern {
    int singles = 0, pairs = 0;
};

std::vector<Pattern> patternsOf(int count)
{
    std::vector<Pattern> patterns;
    for (int pairs = 0; 2 * pairs < count; ++pairs)
        patterns.push_back({count - 2 * pairs, pairs});
    return patterns;
}

/// Groups with their products kept, so that changing one of them costs a row.
class GroupSet {
public:
    explicit GroupSet(const KernelProducts& kernel) : m_kernel(&kernel) {}

    size_t size() const { return m_size; }
    const Group& operator[](size_t i) const { return m_members[i].group; }
    void put(size_t i, const Group& group)
    {
        m_size = std::max(m_size, i + 1);
        Member& member = m_members[i];
        member = {group, LobeProducts::taps(group.alpha), lookupAxis(group.offset, group.turn)};
        m_b[i] = m_kernel->at(member.taps, member.axis);
        for (size_t j = 0; j < m_size; ++j)
            m_gram[i][j] = m_gram[j][i] = product(member, m_members[j]);
    }
    /// Share of the kernel's square that the best weights leave.
    double left() const { return std::max(solve(m_gram, m_b, m_size).cost + m_kernel->square(), 0.0) / m_kernel->square(); }

private:
    struct Member {
        Group group{};
        CubicTaps taps{};
        glm::dvec3 axis{0.0, 0.0, 1.0};
    };
    /// Of pairs the mean over both sides.
    double product(const Member& a, const Member& b) const
    {
        const LobeProducts& lobes = m_kernel->lobes();
        const double near = lobes.at(a.taps, b.taps, glm::dot(a.axis, b.axis));
        if (!(a.group.isPair && b.group.isPair))
            return near;
        return 0.5 * (near + lobes.at(a.taps, b.taps, glm::dot(a.axis, b.axis * glm::dvec3(1.0, -1.0, 1.0))));
    }

    const KernelProducts* m_kernel;
    size_t m_size = 0;
    std::array<Member, mostLookups> m_members{};
    Small m_gram{};
    std::array<double, mostLookups> m_b{};
};

/// How far a table's entries may lie: above the horizon and a little below it, where a lobe's tail is all that is above.
struct Range {
    double least, most;
};
Range offsetRange(double view) { return {-(0.5 * pi - view) - 0.15, 0.5 * pi + view}; }

/// A group with one of its numbers moved, within its range.
enum class Knob { Offset, Width, Turn };
Group moved(Group group, Knob knob, double step, const Range& offsets)
{
    if (knob == Knob::Offset)
        group.offset = std::clamp(group.offset + step, offsets.least, offsets.most);
    else if (knob == Knob::Width)
        group.alpha = std::clamp(group.alpha * std::exp(step), leastLookupAlpha, 1.0);
    else
        group.turn = std::clamp(group.turn + step, 0.0, 0.5 * pi);
    return group;
}

/// Coordinate search: steps grow where they help and halve where they do not.
void refine(GroupSet& set, const Range& offsets)
{
    struct Step {
        size_t group;
        Knob knob;
        double size, least;
    };
    std::vector<Step> steps;
    for (size_t i = 0; i < set.size(); ++i) {
        const double alpha = set[i].alpha;
        steps.push_back({i, Knob::Offset, 0.3 * alpha, 1e-3 * alpha});
        steps.push_back({i, Knob::Width, 0.25, 1e-3});
        if (set[i].isPair)
            steps.push_back({i, Knob::Turn, 0.3 * alpha, 1e-3 * alpha});
    }
    double best = set.left();
    for (int round = 0; round < 80; ++round) {
        const double before = best;
        bool isFine = true;
        for (Step& step : steps) {
            bool improved = false;
            for (const double direction : {1.0, -1.0}) {
                GroupSet tried = set;
                tried.put(step.group, moved(set[step.group], step.knob, direction * step.size, offsets));
                const double left = tried.left();
                if (left < best) {
                    best = left;
                    set = tried;
                    improved = true;
                    step.size *= direction;
                    break;
                }
            }
            step.size *= improved ? 1.6 : 0.5;
            isFine = isFine && std::abs(step.size) < step.least;
        }
        if (isFine || (round > 12 && before - best < 1e-4 * before))
            break;
    }
}

/// Where a group may begin: dense about r, as wide as the material's lobe and around it.
std::vector<Group> candidates(double alpha, const Range& offsets, bool arePairs)
{
    std::vector<Group> all;
    const int steps = arePairs ? 6 : 12;
    for (const double width : {0.2, 0.35, 0.5, 0.7, 1.0, 1.5, 2.2})
        for (int i = -steps; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps, offset = (i < 0 ? -offsets.least : offsets.most) * share * std::abs(share);
            Group group{
                .offset = std::max(offset, offsets.least), .alpha = std::clamp(width * alpha, leastLookupAlpha, 1.0), .isPair = arePairs};
            if (!arePairs)
                all.push_back(group);
            else
                for (const double turn : {0.3, 0.6, 1.0, 1.5}) {
                    group.turn = std::min(turn * alpha, 0.45 * pi);
                    all.push_back(group);
                }
        }
    return all;
}

/// From nothing: the best of the candidates, one after the other, each followed by a search.
GroupSet fitAnew(const KernelProducts& kernel, double alpha, const Pattern& pattern, const Range& offsets)
{
    GroupSet set(kernel);
    const std::vector<Group> singles = candidates(alpha, offsets, false), pairs = candidates(alpha, offsets, true);
    for (int k = 0; k < pattern.singles + pattern.pairs; ++k) {
        double best = 1e300;
        const Group* chosen = nullptr;
        for (const Group& group : k < pattern.singles ? singles : pairs) {
            GroupSet tried = set;
            tried.put(set.size(), group);
            if (const double left = tried.left(); left < best) {
                best = left;
                chosen = &group;
            }
        }
        set.put(set.size(), *chosen);
        refine(set, offsets);
    }
    return set;
}

/// A view made ready: its kernel's spectrum and products.
struct View {
    double view = 0.0;
    KernelSpectrum spectrum{};
    std::unique_ptr<const KernelProducts> products{};
};

/// As many degrees as a lobe of this width fills, and as many orders as a lobe bent along the plane of incidence.
View madeReady(const Brdf& brdf, double view)
{
    const double alpha = equivalentAlpha(brdf) * std::max(std::cos(view), 0.15);
    int bandLimit = 64;
    for (int grown = 96; bandLimit < 512 && bandLimit * alpha < 4.0; grown = bandLimit % 3 == 0 ? bandLimit / 3 * 4 : bandLimit / 2 * 3)
        bandLimit = grown;
    View made{.view = view, .spectrum = kernelSpectrum(ReflectionKernel(brdf, view), bandLimit, 32)};
    made.products = std::make_unique<const KernelProducts>(made.spectrum);
    return made;
}

/// The table's entries of a pattern, each fitted from its neighbor's, from a middling view outwards, so that they change smoothly.
std::vector<GroupSet> march(const std::vector<View>& views, double alpha, const Pattern& pattern, const JobControl& job)
{
    const size_t middle = views.size() / 2;
    std::vector<GroupSet> sets(views.size(), GroupSet(*views[middle].products));
    sets[middle] = fitAnew(*views[middle].products, alpha, pattern, offsetRange(views[middle].view));
    const auto follow = [&](size_t to, size_t from) {
        job.checkStop();
        const Range offsets = offsetRange(views[to].view);
        GroupSet set(*views[to].products);
        for (size_t i = 0; i < sets[from].size(); ++i)
            set.put(i, moved(sets[from][i], Knob::Offset, 0.0, offsets));
        refine(set, offsets);
        sets[to] = set;
    };
    for (size_t i = middle + 1; i < views.size(); ++i)
        follow(i, i - 1);
    for (size_t i = middle; i-- > 0;)
        follow(i, i + 1);
    return sets;
}

/// The weights of every channel, by sums without a table.
LookupFit finish(const View& view, const GroupSet& set)
{
    const KernelSpectrum& spectrum = view.spectrum;
    const ExactProducts exact(spectrum);
    const size_t n = set.size();
    std::array<std::vector<double>, mostLookups> lobes{};
    std::array<glm::dvec3, mostLookups> axes{};
    Small gram{};
    for (size_t i = 0; i < n; ++i) {
        lobes[i] = exact.lobe(set[i].alpha);
        axes[i] = lookupAxis(set[i].offset, set[i].turn);
        for (size_t j = 0; j <= i; ++j) {
            double product = exact.lobes(lobes[i], lobes[j], glm::dot(axes[i], axes[j]));
            if (set[i].isPair && set[j].isPair)
                product = 0.5 * (product + exact.lobes(lobes[i], lobes[j], glm::dot(axes[i], axes[j] * glm::dvec3(1.0, -1.0, 1.0))));
            gram[i][j] = gram[j][i] = product;
        }
    }
    LookupFit fit{.view = view.view};
    for (size_t i = 0; i < n; ++i)
        for (const double side : {1.0, -1.0})
            if (side > 0.0 || set[i].isPair)
                fit.lookups.push_back(
                    {.offset = set[i].offset, .alpha = set[i].alpha, .weight = glm::dvec3(0.0), .turn = side * set[i].turn});
    const int channels = spectrum.isGray ? 1 : 3;
    std::array<std::array<double, mostLookups>, 3> b{};
    for (size_t i = 0; i < n; ++i) {
        const glm::dvec3 products = exact.kernel(lobes[i], axes[i]);
        for (size_t c = 0; c < 3; ++c)
            b[c][i] = products[static_cast<int>(c)];
    }
    double left = 0.0;
    for (int c = 0; c < channels; ++c) {
        const Weights weights = solve(gram, b[static_cast<size_t>(c)], n);
        left += std::max(weights.cost + exact.square(c), 0.0) / exact.square(c);
        size_t at = 0;
        for (size_t i = 0; i < n; ++i)
            for (int side = 0; side < (set[i].isPair ? 2 : 1); ++side, ++at)
                fit.lookups[at].weight[c] = weights.w[i] * spectrum.albedo[c] * (set[i].isPair ? 0.5 : 1.0);
    }
    if (spectrum.isGray)
        for (BrdfLookup& lookup : fit.lookups)
            lookup.weight = glm::dvec3(lookup.weight.x);
    fit.residual = std::sqrt(left / channels);
    return fit;
}

} // namespace

LookupFit fitLookups(const Brdf& brdf, double view, int count) { return fitLookups(brdf, std::array{view}, count).front(); }

std::vector<LookupFit> fitLookups(const Brdf& brdf, std::span<const double> angles, int count, const JobControl& job)
{
    if (count < 1 || count > static_cast<int>(mostLookups))
        throw InvalidArgument("lookups: must be a whole number from 1 to " + std::to_string(mostLookups));
    std::vector<View> views(angles.size());
    const auto each = [&](size_t number, auto&& work) {
        parallelRows(
            static_cast<int>(number), job,
            [&](int first, int last) {
                for (int i = first; i < last; ++i)
                    work(static_cast<size_t>(i));
            },
            1);
    };
    each(views.size(), [&](size_t i) { views[i] = madeReady(brdf, angles[i]); });
    const std::vector<Pattern> patterns = patternsOf(count);
    std::vector<std::vector<GroupSet>> tried(patterns.size());
    each(patterns.size(), [&](size_t p) { tried[p] = march(views, equivalentAlpha(brdf), patterns[p], job); });
    const auto leftBy = [](const std::vector<GroupSet>& sets) {
        double sum = 0.0;
        for (const GroupSet& set : sets)
            sum += set.left();
        return sum;
    };
    const auto best = std::min_element(tried.begin(), tried.end(), [&](const auto& a, const auto& b) { return leftBy(a) < leftBy(b); });
    std::vector<LookupFit> fits(views.size());
    each(views.size(), [&](size_t i) { fits[i] = finish(views[i], (*best)[i]); });
    return fits;
}

} // namespace mirrorball
