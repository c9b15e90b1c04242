#pragma once

#include "lobe.h"
#include "method.h"
#include "transfer_model.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"
#include "core/image/mip_pyramid.h"

namespace mirrorball {

/// The lambda blur (002 section 2): a reflection looks the environment's mip pyramid up with a *minimum* level of detail lambda, so that
/// the same map serves every width of lobe. A coarse approximation: the kernel is what the pyramid happens to have, and view-independent.
///
/// Lambda counts levels of the environment's own cube map, environmentCube(), whatever map the result is written to.

/// The cube map of an environment that is `latlongWidth` texels around: faces of the power of two at or below a quarter of that.
MapLayout environmentCube(int latlongWidth);

/// The levels of a cube map, filtered across its seams (buildMipPyramid), or each face by itself: 2 x 2 boxes without weights, as
/// gluBuild2DMipmaps and the drivers of 2002 made them (002 section 3).
MipPyramid blurPyramid(const EnvironmentMap& cube, MipFiltering filtering, const JobControl& job = {});

/// Variance per axis, in square radians, of what a trilinear lookup at `level` averages over in a map with this mean solid angle h^2 of a
/// texel. Each halving convolves with [1 3 3 1]/8, whose variance is 3/4 of a square texel, and the bilinear lookup with a tent of 1/6:
///   sigma^2(level) = h^2 (4^level (1/4 + 1/6) - 1/4),  linear between whole levels
double blurVariance(double level, double h2);

/// The level whose blur has this variance: the inverse, not below 0.
double levelForVariance(double variance, double h2);

/// The level whose blur is as wide as the lobe: the widths agree in degree 1 of the spectrum, k_1 = E[cos t]. A blur of variance
/// sigma^2 per axis has exp(-sigma^2) there, so that
///   sigma^2 = -ln k_1,   for phong ln((n+2)/(n+1)), about 1/n
/// and levelForVariance() is the answer.
double matchedLambda(const Lobe& lobe, const MapLayout& environment);
/// The inverse: the phong exponent whose width lambda stands for, n = 1/(exp(sigma^2) - 1) - 1, at least 0.
double matchedExponent(double lambda, const MapLayout& environment);

/// Looks the pyramid up at every texel of the target, with level max(lambda, that of the target's own texel size).
/// @param lambda  at least 0; beyond the last level it is that level
/// @throws Cancelled
EnvironmentMap mipBlur(const MipPyramid& pyramid, MipFiltering filtering, double lambda, const MapLayout& target, double yaw,
                       const JobControl& job = {});

/// What the blur is made of: the two levels beside lambda.
std::vector<TransferModel::Blur> mipBlurs(double lambda, const MapLayout& environment);

/// What the blur does to the spectrum, degree by degree: mix of exp(-l(l+1) sigma^2/2) over those two.
std::vector<double> mipTransfer(double lambda, const MapLayout& environment, int bandLimit);

/// How far the blur differs from its mean from place to place, since a level's texels stand where they stand: the variance of the transfer
/// over places between the texels of size h. With boxes B(t) = sinc(t/2) of which a bilinear lookup mixes two an axis,
///   mean over places B M,  M = sinc^2(t/2);   mean of squares B^2 (1 - (1 - cos t)/3);   t = h sqrt(l(l+1)) along the axis,
/// averaged over headings; the two levels beside lambda taken as independent. It is what a sun shows, whose power falls in no degree.
std::vector<double> mipScatter(double lambda, const MapLayout& environment, int bandLimit);

} // namespace mirrorball
