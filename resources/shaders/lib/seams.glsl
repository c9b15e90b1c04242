#pragma once
// Where a map's texels are no neighbors although their directions are: SEAMS_OF in the order of core's enum of parameterizations.
struct Seam {
    vec3 across; // unit; |across . d| is the angle from d to the nearest seam, to first order
    int chart;   // that d lies in
};
vec3 awayFrom(vec3 v)
{
    return v / max(length(v), 1e-20);
}
Seam seam(vec3 d)
{
#if SEAMS_OF == 0 // the meridian of -Z, from pole to pole
    return Seam(d.z < 0.0 ? vec3(1.0, 0.0, 0.0) : awayFrom(vec3(d.x, 0.0, d.z)), 0);
#elif SEAMS_OF == 1 // the edges of the cube: the two largest components are equal
    vec3 a = abs(d), s = sign(d) * inversesqrt(2.0);
    int face = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    int beside = face == 0 ? (a.y >= a.z ? 1 : 2) : face == 1 ? (a.x >= a.z ? 0 : 2) : a.x >= a.y ? 0 : 1;
    vec3 across = vec3(0.0);
    across[face] = s[face];
    across[beside] = -s[beside];
    return Seam(across, 2 * face + (d[face] > 0.0 ? 0 : 1));
#elif SEAMS_OF == 2 || SEAMS_OF == 3 // the rim, which is one direction
    return Seam(d.z < 0.0 ? awayFrom(vec3(d.xy, 0.0)) : d, 0);
#elif SEAMS_OF == 4 // the equator between the halves
    return Seam(vec3(0.0, 0.0, 1.0), d.z >= 0.0 ? 0 : 1);
#else // the edge of the unfolded sheet: four meridians of the lower half
    vec3 across = abs(d.x) < abs(d.z) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
    return Seam(d.y < 0.0 ? across : awayFrom(across * d + vec3(0.0, d.y, 0.0)), d.y >= 0.0 ? 0 : 1);
#endif
}
