#pragma once

#include <QImage>
#include <QString>

namespace mirrorball::studio {

/// Writes a picture that came without a file, from a clipboard or a browser, as a PNG: beside the scene, in the folder "pasted", or where
/// the scene has no file yet in the user's data. The same picture is one file. @return its path; empty where it cannot be written
QString keepPicture(const QImage& picture, const QString& sceneFile);

} // namespace mirrorball::studio
