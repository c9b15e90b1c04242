#include "picture_use.h"

#include "widgets/controls/text.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/layout_detection.h"

namespace mirrorball::studio {

std::optional<PictureFacts> pictureFacts(const QString& path)
{
    if (path.contains(QStringLiteral("%s")))
        return std::nullopt;
    try {
        const ImageFileInfo info = openImage(toPath(path))->info();
        PictureFacts facts{
            .isSquare = info.width == info.height, .saysSphereMap = info.attributes.contains("mirrorball:index"), .levels = info.levels};
        facts.mayBeBall = facts.isSquare && info.width > 1 && !detectLayout(info).certain;
        return facts;
    } catch (const Error&) {
        return std::nullopt; // whoever uses it tells what is wrong
    }
}

std::optional<PictureUse> useOfPicture(const PictureFacts& facts, DropPlace place)
{
    switch (place) {
    case DropPlace::Layers:
        return PictureUse::Layer;
    case DropPlace::SphereMap:
        return PictureUse::SphereMap;
    case DropPlace::BesideSphereMap:
        return facts.mayBeBall || facts.saysSphereMap ? PictureUse::SphereMap : PictureUse::Probe;
    case DropPlace::Elsewhere:
        if (facts.saysSphereMap)
            return PictureUse::SphereMap;
        return facts.mayBeBall ? std::nullopt : std::optional(PictureUse::Probe);
    }
    return PictureUse::Probe;
}

} // namespace mirrorball::studio
