#include "surface_picture.h"

#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/image_io.h"
#include "core/image/repair.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// How far the lengths of vectors are from 1, on the mean, if x stands for scale x + offset.
double lengthError(const Image& picture, double scale, double offset)
{
    double sum = 0.0;
    for (size_t i = 0; i < picture.texels.size(); i += 3) {
        const glm::dvec3 stored(picture.texels[i], picture.texels[i + 1], picture.texels[i + 2]);
        sum += std::abs(glm::length(scale * stored + offset) - 1.0);
    }
    return sum;
}

void decodeNormals(Image& picture, bool mayHoldVectors)
{
    if (!mayHoldVectors || lengthError(picture, 1.0, 0.0) > lengthError(picture, 2.0, -1.0))
        for (float& x : picture.texels)
            x = 2.0f * x - 1.0f;
    for (float& x : picture.texels)
        x = std::clamp(x, -1.0f, 1.0f);
}

Image readPicture(const std::string& path, SurfacePictureUse use, const JobControl& job)
{
    const bool isNormal = use == SurfacePictureUse::Normal;
    const auto reader = openImage(path, isNormal ? ProbeReading{.colorSpace = "linear"} : ProbeReading{});
    const ImageFileInfo& info = reader->info();
    if (info.width > largestSurfacePicture || info.height > largestSurfacePicture)
        throw FileError(path, "is " + std::to_string(info.width) + " x " + std::to_string(info.height) +
                                  " texels; a picture on a mesh has at most " + std::to_string(largestSurfacePicture) +
                                  " an edge, make it smaller");
    Image picture = readAll(*reader, job);
    repair(picture, isNormal ? NegativePolicy::Keep : NegativePolicy::Clamp);
    if (isNormal)
        decodeNormals(picture, info.sampleType == "float" || info.sampleType == "half");
    return picture;
}

Image shares(const Image& picture)
{
    Image share(picture.width, picture.height, 1);
    for (size_t i = 0; i < share.texels.size(); ++i) {
        const float* rgb = &picture.texels[3 * i];
        share.texels[i] = static_cast<float>(std::min(luminance({rgb[0], rgb[1], rgb[2]}), 1.0));
    }
    return share;
}

} // namespace

PictureLevels readSurfacePicture(const Scene& scene, const SurfacePicturePlan& plan, const JobControl& job)
{
    try {
        Image picture = readPicture(resolved(scene, plan.source), plan.use, job);
        if (plan.use == SurfacePictureUse::Share)
            picture = shares(picture);
        return std::make_shared<const std::vector<Image>>(pictureLevels(std::move(picture), job));
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(plan.field + ": " + error.what());
    }
}

} // namespace mirrorball
