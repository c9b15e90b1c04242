#include "painted_pictures.h"

#include "matcap_passes.h"

#include "core/base/error.h"
#include "core/image/opacity.h"

#include <algorithm>
#include <string>

namespace mirrorball {

namespace {

std::vector<Image> evaluated(const SphereMapDocument& document, const PaintedOptions& options, const JobControl& job)
{
    const EvaluateOptions whole{.size = options.size - 2 * options.border};
    switch (options.levels) {
    case PaintedLevels::Authored:
        return evaluateLevels(document, whole, job);
    case PaintedLevels::Plain:
        return plainChain(evaluate(document, whole, job), job);
    case PaintedLevels::One:
        break;
    }
    return {bordered(evaluate(document, whole, job), options.border)};
}

} // namespace

bool isOpaque(const Image& rgba)
{
    for (size_t i = 3; i < rgba.texels.size(); i += 4)
        if (rgba.texels[i] < 1.0f - 1e-6f)
            return false;
    return true;
}

void validate(const PaintedOptions& options)
{
    if (options.border < 0 || 2 * options.border >= std::max(1, options.size))
        throw InvalidArgument("border: must leave room for the map between the borders of a picture of " + std::to_string(options.size) +
                              " texels; it is " + std::to_string(options.border));
    if (options.border > 0 && options.levels != PaintedLevels::One)
        throw InvalidArgument("border: must be 0 where all levels are painted, for it has no half in the smaller ones; it is " +
                              std::to_string(options.border));
}

std::vector<Image> paintedPictures(const SphereMapDocument& document, const PaintedOptions& options, const JobControl& job)
{
    validate(options);
    std::vector<Image> pictures = evaluated(document, options, job);
    if (std::all_of(pictures.begin(), pictures.end(), isOpaque))
        std::transform(pictures.begin(), pictures.end(), pictures.begin(), withoutOpacity);
    return pictures;
}

WriteOptions paintedFileOptions(const SphereMapDocument& document, SampleType samples)
{
    const std::string index(wordOf(document.index));
    return {.sampleType = samples, .attributes = {{"mirrorball:parameterization", "sphere"}, {"mirrorball:index", index}}};
}

} // namespace mirrorball
