#include "brdf_lookups.h"

#include "lobe.h"
#include "spin_transform.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace mirrorball {

namespace {

constexpr double leastAlpha = 2e-3, growth = 1.12; ///< of the tabulated lobes
constexpr size_t mostLookups = 8;

/// Legendre coefficients of ggx lobes at many widths, linear in ln alpha between them.
class LobeTable {
public:
    explicit LobeTable(int bandLimit)
    {
        for (double alpha = leastAlpha;; alpha *= growth) {
            m_k.push_back(legendreCoefficients(ggxLobe(std::min(alpha, 1.0)), bandLimit));
            if (alpha >= 1.0)
                break;
        }
    }
    void read(double alpha, std::vector<double>& k) const
    {
        const double x = std::clamp(std::log(alpha / leastAlpha) / std::log(growth), 0.0, static_cast<double>(m_k.size() - 1) - 1e-9);
        const auto i = static_cast<size_t>(x);
        const double t = x - static_cast<double>(i);
        k.resize(m_k[0].size());
        for (size_t l = 0; l < k.size(); ++l)
            k[l] = (1.0 - t) * m_k[i][l] + t * m_k[i + 1][l];
    }

    /// Made once for each band limit (powers of two): a table is read by every fit.
    static std::shared_ptr<const LobeTable> of(int bandLimit)
    {
        static std::mutex mutex;
        static std::map<int, std::shared_ptr<const LobeTable>> made;
        const std::lock_guard lock(mutex);
        auto& table = made[bandLimit];
        if (!table)
            table = std::make_shared<const LobeTable>(bandLimit);
        return table;
    }

private:
    std::vector<std::vector<double>> m_k{};
};

struct Atom {
    double offset, alpha;
};

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

/// The kernel, the metric and the lobes in one place: costs of sets of atoms.
class Fitter {
public:
    Fitter(const KernelSpectrum& kernel, const LobeTable& lobes) : m_kernel(kernel), m_lobes(lobes)
    {
        // Of a kernel in color the form is fitted to the mean of its channels.
        const auto degrees = static_cast<size_t>(kernel.bandLimit) + 1;
        m_metric.resize(degrees);
        for (size_t l = 1; l < degrees; ++l)
            m_metric[l] = 1.0 / ((2.0 * static_cast<double>(l) + 1.0) * (static_cast<double>(l) + 1.0));
        for (int c = 0; c < channels(); ++c)
            m_square[static_cast<size_t>(c)] = squareOf(c);
        for (int m = 0; m <= kernel.orders; ++m)
            m_harmonics.emplace_back(m, kernel.bandLimit);
        for (size_t l = 0; l < degrees; ++l)
            m_scale.push_back(std::sqrt((2.0 * static_cast<double>(l) + 1.0) / (4.0 * pi)));
    }

    int channels() const { return m_kernel.isGrey ? 1 : 3; }
    double square(int channel) const { return m_square[m_kernel.isGrey ? 0 : static_cast<size_t>(channel)]; }

    /// sum_l s_l k_l(alpha) (the kernel's part of degree l, read at the atom's axis)
    std::array<double, 3> meets(const Atom& atom) const
    {
        std::vector<double> k, part;
        m_lobes.read(atom.alpha, k);
        std::array<double, 3> sum{};
        for (int c = 0; c < channels(); ++c) {
            kernelAlong(atom.offset, c, part);
            for (size_t l = 1; l < m_metric.size(); ++l)
                sum[static_cast<size_t>(c)] += m_metric[l] * k[l] * part[l];
        }
        return sum;
    }
    double meets(const Atom& a, const Atom& b) const
    {
        std::vector<double> ka, kb;
        m_lobes.read(a.alpha, ka);
        m_lobes.read(b.alpha, kb);
        const double x = std::cos(a.offset - b.offset);
        double before = 1.0, p = x, sum = 0.0;
        for (size_t l = 1; l < m_metric.size(); ++l) {
            const auto d = static_cast<double>(l);
            sum += m_metric[l] * ka[l] * kb[l] * (2.0 * d + 1.0) / (4.0 * pi) * p;
            const double next = ((2.0 * d + 1.0) * x * p - d * before) / (d + 1.0);
            before = p;
            p = next;
        }
        return sum;
    }

private:
    double squareOf(int c) const
    {
        double sum = 0.0;
        for (int m = 0; m <= m_kernel.orders; ++m)
            for (int l = std::max(m, 1); l <= m_kernel.bandLimit; ++l)
                sum += m_metric[static_cast<size_t>(l)] * m_kernel.term(l, m, c);
        return sum;
    }
    /// The kernel's part of each degree at a place in the plane of incidence. The offset is chi = 0 where positive, chi = pi where
    /// negative.
    void kernelAlong(double offset, int channel, std::vector<double>& part) const
    {
        const auto degrees = static_cast<size_t>(m_kernel.bandLimit) + 1;
        std::vector<double> lambda(degrees);
        part.assign(degrees, 0.0);
        for (int m = 0; m <= m_kernel.orders; ++m) {
            m_harmonics[static_cast<size_t>(m)].at(std::abs(offset), lambda);
            const double sign = offset < 0.0 && m % 2 == 1 ? -1.0 : 1.0;
            const auto k = m_kernel.order(m, channel);
            for (size_t l = static_cast<size_t>(m); l < degrees; ++l)
                part[l] += sign * k[l] * m_scale[l] * lambda[l];
        }
    }

    const KernelSpectrum& m_kernel;
    const LobeTable& m_lobes;
    std::vector<OrderHarmonics> m_harmonics{};
    std::vector<double> m_metric{}, m_scale{};
    std::array<double, 3> m_square{};
};

/// A set of atoms with its products kept, so that changing one of them costs a row.
struct AtomSet {
    std::vector<Atom> atoms{};
    Small gram{};
    std::array<std::array<double, mostLookups>, 3> b{};

    void put(const Fitter& fitter, size_t i, const Atom& atom)
    {
        if (i == atoms.size())
            atoms.push_back(atom);
        atoms[i] = atom;
        const auto meets = fitter.meets(atom);
        for (size_t c = 0; c < 3; ++c)
            b[c][i] = meets[c];
        for (size_t j = 0; j < atoms.size(); ++j)
            gram[i][j] = gram[j][i] = fitter.meets(atom, atoms[j]);
    }
    /// Mean over the channels of the square that is left, over that of the kernel.
    double left(const Fitter& fitter) const
    {
        double sum = 0.0;
        for (int c = 0; c < fitter.channels(); ++c)
            sum += std::max(solve(gram, b[static_cast<size_t>(c)], atoms.size()).cost + fitter.square(c), 0.0) / fitter.square(c);
        return sum / fitter.channels();
    }
};

struct Range {
    double least, most;
};

/// Coordinate search with steps that halve where nothing improves.
void refine(const Fitter& fitter, AtomSet& set, const Range& offsets)
{
    double best = set.left(fitter);
    std::vector<std::array<double, 2>> steps;
    for (const Atom& atom : set.atoms)
        steps.push_back({0.3 * atom.alpha, 0.25});
    for (int round = 0; round < 60; ++round) {
        const double before = best;
        bool isFine = true;
        for (size_t i = 0; i < set.atoms.size(); ++i)
            for (size_t axis = 0; axis < 2; ++axis) {
                bool improved = false;
                for (const double direction : {1.0, -1.0}) {
                    AtomSet tried = set;
                    Atom atom = set.atoms[i];
                    const double step = direction * steps[i][axis];
                    if (axis == 0)
                        atom.offset = std::clamp(atom.offset + step, offsets.least, offsets.most);
                    else
                        atom.alpha = std::clamp(atom.alpha * std::exp(step), leastAlpha, 1.0);
                    tried.put(fitter, i, atom);
                    const double left = tried.left(fitter);
                    if (left < best) {
                        best = left;
                        set = tried;
                        improved = true;
                        break;
                    }
                }
                steps[i][axis] *= improved ? 1.6 : 0.5;
                isFine = isFine && steps[i][axis] < (axis == 0 ? 2e-3 * set.atoms[i].alpha : 2e-3);
            }
        if (isFine || (round > 12 && before - best < 1e-5 * before))
            break;
    }
}

LookupFit finish(const Fitter& fitter, const KernelSpectrum& kernel, const AtomSet& set)
{
    LookupFit fit{.view = kernel.view, .residual = std::sqrt(set.left(fitter))};
    for (const Atom& atom : set.atoms)
        fit.lookups.push_back({atom.offset, atom.alpha, glm::dvec3(0.0)});
    for (int c = 0; c < 3; ++c) {
        const Weights weights = solve(set.gram, set.b[kernel.isGrey ? 0 : static_cast<size_t>(c)], set.atoms.size());
        for (size_t i = 0; i < fit.lookups.size(); ++i)
            fit.lookups[i].weight[c] = weights.w[i] * kernel.albedo[c];
    }
    std::sort(fit.lookups.begin(), fit.lookups.end(), [](const BrdfLookup& a, const BrdfLookup& b) { return a.offset < b.offset; });
    return fit;
}

/// As many degrees as a lobe of this width fills, and as many orders as a lobe bent along the plane of incidence.
KernelSpectrum spectrumFor(const Brdf& brdf, double view)
{
    const double alpha = equivalentAlpha(brdf) * std::max(std::cos(view), 0.15);
    int bandLimit = 64;
    while (bandLimit < 512 && bandLimit * alpha < 6.0)
        bandLimit *= 2;
    return kernelSpectrum(ReflectionKernel(brdf, view), bandLimit, 32);
}

/// Lookups lie above the horizon and a little below it, where a lobe's tail is all that is above.
Range offsetRange(double view) { return {-(0.5 * pi - view) - 0.15, 0.5 * pi + view}; }

} // namespace

LookupFit fitLookups(const Brdf& brdf, double view, int count)
{
    if (count < 1 || count > static_cast<int>(mostLookups))
        throw InvalidArgument("lookups: must be a whole number from 1 to " + std::to_string(mostLookups));
    const KernelSpectrum kernel = spectrumFor(brdf, view);
    const auto lobes = LobeTable::of(kernel.bandLimit);
    const Fitter fitter(kernel, *lobes);
    const Range offsets = offsetRange(view);
    const double alpha = equivalentAlpha(brdf);

    // Candidates: dense about r, as wide as the material's lobe and around it.
    std::vector<Atom> candidates;
    for (const double width : {0.2, 0.35, 0.5, 0.7, 1.0, 1.5, 2.2})
        for (int i = -12; i <= 12; ++i) {
            const double offset = (i < 0 ? -offsets.least : offsets.most) * i * std::abs(i) / 144.0;
            candidates.push_back({i < 0 ? std::max(offset, offsets.least) : offset, std::clamp(width * alpha, leastAlpha, 1.0)});
        }
    AtomSet set;
    for (int k = 0; k < count; ++k) {
        double best = 1e300;
        AtomSet chosen;
        for (const Atom& atom : candidates) {
            AtomSet tried = set;
            tried.put(fitter, set.atoms.size(), atom);
            const double left = tried.left(fitter);
            if (left < best) {
                best = left;
                chosen = std::move(tried);
            }
        }
        set = std::move(chosen);
        refine(fitter, set, offsets);
    }
    return finish(fitter, kernel, set);
}

LookupFit fitLookups(const Brdf& brdf, double view, const LookupFit& start)
{
    const KernelSpectrum kernel = spectrumFor(brdf, view);
    const auto lobes = LobeTable::of(kernel.bandLimit);
    const Fitter fitter(kernel, *lobes);
    const Range offsets = offsetRange(view);
    AtomSet set;
    for (const BrdfLookup& lookup : start.lookups)
        set.put(fitter, set.atoms.size(),
                {std::clamp(lookup.offset, offsets.least, offsets.most), std::clamp(lookup.alpha, leastAlpha, 1.0)});
    refine(fitter, set, offsets);
    return finish(fitter, kernel, set);
}

} // namespace mirrorball
