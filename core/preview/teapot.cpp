#include "mesh.h"
#include "teapot_patches.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

namespace {

using Weights = std::array<double, 4>;

// The cubic Bernstein polynomials at t = i/n. t and 1 - t are each one division, so that running through an edge the other way gives
// the same numbers in reverse.
Weights bernstein(int i, int n)
{
    const double t = double(i) / n, s = double(n - i) / n;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

// Their derivatives by t.
Weights bernsteinDerivative(int i, int n)
{
    const double t = double(i) / n, s = double(n - i) / n;
    return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

// Outer ones first, inner ones second: the sum is the same bits when the points and the weights run the other way.
glm::dvec3 weightedSum(const Weights& w, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    return (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c);
}

glm::dvec3 evaluate(const BezierPatch& patch, const Weights& u, const Weights& v)
{
    glm::dvec3 columns[4];
    for (size_t k = 0; k < 4; ++k)
        columns[k] = weightedSum(v, patch[k], patch[4 + k], patch[8 + k], patch[12 + k]);
    return weightedSum(u, columns[0], columns[1], columns[2], columns[3]);
}

// A point of the surface. An edge v = 0 or v = 1 that is one point comes out as that point, with no rounding along the edge.
glm::dvec3 positionAt(const BezierPatch& patch, int i, int j, int uLevel, int vLevel)
{
    const auto isPoint = [&](size_t row) {
        return patch[row] == patch[row + 1] && patch[row] == patch[row + 2] && patch[row] == patch[row + 3];
    };
    if (j == 0 && isPoint(0))
        return patch[0];
    if (j == vLevel && isPoint(12))
        return patch[12];
    return evaluate(patch, bernstein(i, uLevel), bernstein(j, vLevel));
}

// The outward unit normal S_v x S_u. Where a whole edge v = 0 or v = 1 is one point (the knob's tip, the middle of the bottom) S_u
// vanishes there; beside the edge it is S_u(v) = +-|v - edge| S_uv + ..., so its direction tends to that of S_uv, pointed into the patch.
glm::dvec3 normalAt(const BezierPatch& patch, int i, int j, int uLevel, int vLevel)
{
    const Weights u = bernstein(i, uLevel), v = bernstein(j, vLevel);
    const Weights du = bernsteinDerivative(i, uLevel), dv = bernsteinDerivative(j, vLevel);
    glm::dvec3 alongU = evaluate(patch, du, v);
    const glm::dvec3 alongV = evaluate(patch, u, dv);
    if (glm::length(alongU) < 1e-9)
        alongU = (j == 0 ? 1.0 : -1.0) * evaluate(patch, du, dv);
    return glm::normalize(glm::cross(alongV, alongU));
}

} // namespace

Mesh teapotMesh(int level)
{
    Mesh mesh;
    std::vector<glm::dvec3> positions;
    const TeapotPatches patches = teapotPatches();
    for (size_t number = 0; number < patches.size(); ++number) {
        const BezierPatch& patch = patches[number].points;
        const auto quads = [level](double share) { return std::max(2, static_cast<int>(std::lround(share * level))); };
        const int uLevel = quads(patches[number].uShare), vLevel = quads(patches[number].vShare);
        if (number == firstOpenPatch)
            mesh.openFrom = mesh.indices.size();
        const size_t first = positions.size(), stride = static_cast<size_t>(uLevel) + 1;
        for (int j = 0; j <= vLevel; ++j)
            for (int i = 0; i <= uLevel; ++i) {
                positions.push_back(positionAt(patch, i, j, uLevel, vLevel));
                mesh.normals.emplace_back(normalAt(patch, i, j, uLevel, vLevel));
                mesh.texCoords.emplace_back(double(i) / uLevel, double(j) / vLevel);
            }
        const auto addTriangle = [&](size_t a, size_t b, size_t c) {
            if (positions[a] == positions[b] || positions[b] == positions[c] || positions[c] == positions[a])
                return; // the edge that is one point
            for (const size_t index : {a, b, c})
                mesh.indices.push_back(static_cast<std::uint32_t>(index));
        };
        for (size_t j = 0; j < static_cast<size_t>(vLevel); ++j)
            for (size_t i = 0; i + 1 < stride; ++i) {
                const size_t corner = first + j * stride + i;
                addTriangle(corner, corner + stride, corner + stride + 1);
                addTriangle(corner, corner + stride + 1, corner + 1);
            }
    }

    // Centered on the bounding box and scaled in double, so that equal positions stay equal.
    glm::dvec3 low = positions.front(), high = low;
    for (const glm::dvec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const glm::dvec3 center = 0.5 * (low + high);
    double radius = 0.0;
    for (const glm::dvec3& position : positions)
        radius = std::max(radius, glm::distance(position, center));
    for (const glm::dvec3& position : positions)
        mesh.positions.emplace_back((position - center) / radius);
    return mesh;
}

} // namespace mirrorball::preview
