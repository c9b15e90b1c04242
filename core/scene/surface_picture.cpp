#include "surface_picture.h"

#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/image_io.h"
#include "core/image/repair.h"

#include <algorithm>

namespace mirrorball {

namespace {

Image readPicture(const std::string& path, const JobControl& job)
{
    const auto reader = openImage(path);
    const ImageFileInfo& info = reader->info();
    if (info.width > largestSurfacePicture || info.height > largestSurfacePicture)
        throw FileError(path, "is " + std::to_string(info.width) + " x " + std::to_string(info.height) +
                                  " texels; a picture on a mesh has at most " + std::to_string(largestSurfacePicture) +
                                  " an edge, make it smaller");
    Image picture = readAll(*reader, job);
    repair(picture, NegativePolicy::Clamp);
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
        Image picture = readPicture(resolved(scene, plan.source), job);
        if (plan.use == SurfacePictureUse::Share)
            picture = shares(picture);
        return std::make_shared<const std::vector<Image>>(pictureLevels(std::move(picture), job));
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(plan.field + ": " + error.what());
    }
}

} // namespace mirrorball
