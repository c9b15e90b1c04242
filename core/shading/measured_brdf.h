#pragma once

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

/// A measured isotropic BRDF: values at many pairs of directions, read between them. A value that is cheap to copy.
class MeasuredBrdf {
public:
    /// What the measurement lacks, and what was done about it.
    struct Gaps {
        size_t samples = 0; ///< all there are
        size_t holes = 0;   ///< that were missing, negative or not finite, and were filled from their neighbors
        size_t clamped = 0; ///< whose color lies outside Rec.709: a channel below 0 became 0
    };
    /// One measured pair of directions.
    struct Sample {
        double nl, nv, lv; ///< cosines
        glm::dvec3 value;  ///< 1/sr
    };
    /// What reads between the values.
    class Table {
    public:
        virtual ~Table() = default;
        virtual glm::dvec3 value(double nl, double nv, double lv) const = 0;
    };

    /// @param samples  that the table was made of, where they are scattered ones
    MeasuredBrdf(std::string name, std::shared_ptr<const Table> table, Gaps gaps, std::vector<Sample> samples = {})
        : m_name(std::move(name)), m_table(std::move(table)), m_gaps(gaps),
          m_samples(std::make_shared<const std::vector<Sample>>(std::move(samples)))
    {
    }

    /// f, 1/sr.
    glm::dvec3 value(double nl, double nv, double lv) const { return m_table->value(nl, nv, lv); }
    /// What the file is called.
    const std::string& name() const { return m_name; }
    const Gaps& gaps() const { return m_gaps; }
    /// Empty where all directions of a grid were measured.
    const std::vector<Sample>& samples() const { return *m_samples; }
    bool operator==(const MeasuredBrdf& other) const { return m_table == other.m_table; }

private:
    std::string m_name;
    std::shared_ptr<const Table> m_table;
    Gaps m_gaps;
    std::shared_ptr<const std::vector<Sample>> m_samples;
};

/// A table over the half-angle coordinates, theta_h in 90 steps of its square root, theta_d in 90, phi_d in 180 steps of pi: linear between
/// the cells' centers. A channel below 0 is a hole; holes take the mean of the neighbors that are known, from the known cells outwards.
/// @param values  per channel [theta_h][theta_d][phi_d], already in 1/sr
/// Source: Matusik, Pfister, Brand and McMillan, "A Data-Driven Reflectance Model", SIGGRAPH 2003, and the reader that comes with its data
MeasuredBrdf halfAngleBrdf(std::string name, std::array<std::vector<float>, 3> values);

/// Samples at any places: between them the mean of the nearest eight by inverse distance, so that each sample keeps its value, taken of
/// ln(1e-5 + f) and over (sqrt(theta_h) cos phi_d, sqrt(theta_h) sin phi_d, theta_d), where a highlight of every incident angle lies at
/// one place. A material is the same seen in a mirror, and light may be traced both ways, so phi_d is folded into [0, pi/2].
/// @param samples  at least one
/// Source: Shepard, "A two-dimensional interpolation function for irregularly-spaced data", 1968, local weights of Franke and Little
MeasuredBrdf scatteredBrdf(std::string name, std::vector<MeasuredBrdf::Sample> samples, MeasuredBrdf::Gaps gaps);

} // namespace mirrorball
