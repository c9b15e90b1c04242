#pragma once
// Where a map's texels are no neighbors although their directions are. Each mapping has a function that tells it, latlongSeam(d) and so on.
struct Seam {
    vec3 across; // unit; |across . d| is the angle from d to the nearest seam, to first order
    int chart;   // that d lies in
};
vec3 awayFrom(vec3 v)
{
    return v / max(length(v), 1e-20);
}
