#pragma once

#include "core/image/image_format.h"

#include <QString>
#include <QStringList>

/// What file dialogs are told of core's table of image formats.
namespace mirrorball::studio {

/// "*.exr", "*.hdr", ...: every extension of every format.
QStringList imagePatterns();
/// The same of the formats that hold light, or a display picture.
enum class Holding { Light, Display };
QStringList imagePatterns(Holding holding);
/// A dialog's filter that shows them all.
QString imageFilter();

} // namespace mirrorball::studio
