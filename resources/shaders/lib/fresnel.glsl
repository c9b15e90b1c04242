#pragma once
// Twin: core/shading/fresnel. The derivations stand there.

// Source: 000 eq. 13, written so that nothing cancels. n2m1 = n^2 - 1 is computed in double by the caller: in single precision an
// index of 1 + 1e-9 would be 1.
float fresnelDielectric(float cosTheta, float n2m1)
{
    float c = clamp(cosTheta, 0.0, 1.0);
    float g2 = n2m1 + c * c;
    if (n2m1 == 0.0)
        return 0.0;
    if (g2 <= 0.0)
        return 1.0; // total internal reflection
    float g = sqrt(g2);
    float sum = g + c;
    float s = n2m1 / (sum * sum);
    float p = (c * sum - 1.0) / (c * (n2m1 / sum) + 1.0);
    return min(1.0, 0.5 * s * s * (1.0 + p * p));
}

// Conductor, all three channels. w = a + ib = sqrt((n + ik)^2 - sin^2), written with real numbers:
//   R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2),   R_p = R_s ((a - s t)^2 + b^2) / ((a + s t)^2 + b^2),   s t = sin^2 / cos
// with the second one multiplied through by c^2, so that it holds at grazing too. The caller keeps k above 0.
vec3 fresnelConductor(float cosTheta, vec3 n, vec3 k)
{
    float c = clamp(cosTheta, 0.0, 1.0);
    float c2 = c * c;
    float s2 = 1.0 - c2;
    vec3 re = (n - 1.0) * (n + 1.0) - k * k + c2;
    vec3 im = 2.0 * n * k;
    vec3 modulus = sqrt(re * re + im * im);
    vec3 a = sqrt(max(0.5 * (modulus + re), 0.0));
    vec3 b = sqrt(max(0.5 * (modulus - re), 0.0));
    vec3 b2 = b * b;
    vec3 rs = ((a - c) * (a - c) + b2) / ((a + c) * (a + c) + b2);
    vec3 below = a * c - s2, above = a * c + s2;
    vec3 rp = rs * (below * below + b2 * c2) / (above * above + b2 * c2);
    return min(vec3(1.0), 0.5 * (rs + rp));
}
