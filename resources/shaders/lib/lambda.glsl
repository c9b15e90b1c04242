#pragma once
// Twin: core/shading/lambda. The least mip level at an angle; the derivation stands there.
float lambdaAt(float lambda, float grazing, float cosTheta)
{
    return max(0.0, lambda + 0.5 * grazing * log2(max(cosTheta, 1e-6)));
}
