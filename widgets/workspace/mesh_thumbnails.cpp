#include "mesh_thumbnails.h"

#include "widgets/controls/text.h"

#include "core/base/failure.h"
#include "core/image/color.h"
#include "core/preview/mesh_file.h"
#include "core/preview/mesh_picture.h"
#include "core/scene/scene.h"

#include <QDateTime>
#include <QFileInfo>
#include <QImage>
#include <QPixmap>

namespace mirrorball::studio {

namespace {

QImage onScreen(const Image& rgba)
{
    QImage image(rgba.width, rgba.height, QImage::Format_RGBA8888_Premultiplied);
    for (int y = 0; y < rgba.height; ++y) {
        uchar* out = image.scanLine(y);
        for (const float* in = rgba.row(y); in != rgba.row(y) + 4 * rgba.width; ++in)
            *out++ = toByte(*in);
    }
    image.setDevicePixelRatio(2.0);
    return image;
}

/// Null where there is no such picture: what is wrong with a mesh is told when it is used.
QImage pictureOf(const QString& geometry, const JobControl& job)
{
    QImage picture;
    failureOf([&] {
        preview::Geometry body{.level = 12};
        if (const auto kind = builtinGeometry(geometry.toStdString()))
            body.kind = *kind;
        else
            body.mesh = std::make_shared<const preview::Mesh>(preview::readMesh(toPath(geometry), job));
        picture = onScreen(preview::meshPicture(body, 2 * MeshThumbnails::pictureEdge));
    });
    return picture;
}

} // namespace

MeshThumbnails::MeshThumbnails(QObject* parent) : QObject(parent) {}
MeshThumbnails::~MeshThumbnails() = default;

QIcon MeshThumbnails::icon(const QString& geometry)
{
    const qint64 time = builtinGeometry(geometry.toStdString()) ? 0 : QFileInfo(geometry).lastModified().toMSecsSinceEpoch();
    const auto found = m_entries.find(geometry);
    if (found != m_entries.end() && found->time == time)
        return found->icon;
    const QIcon before = found != m_entries.end() ? found->icon : QIcon();
    m_entries.insert(geometry, {before, time});
    m_queue.push_back(geometry);
    if (!m_isMaking)
        makeNext();
    return before;
}

void MeshThumbnails::makeNext()
{
    m_isMaking = !m_queue.empty();
    if (!m_isMaking)
        return;
    const QString geometry = m_queue.front();
    m_queue.pop_front();
    m_runner.start(
        [geometry](const JobControl& job) {
            JobControl one = job;
            one.threads = 1; // the picture and the maps come first
            return pictureOf(geometry, one);
        },
        [this, geometry](const QImage& picture) {
            m_entries[geometry].icon = picture.isNull() ? QIcon() : QIcon(QPixmap::fromImage(picture));
            emit made(geometry);
            makeNext();
        },
        Running::Finish);
}

} // namespace mirrorball::studio
