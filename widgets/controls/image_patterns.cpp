#include "image_patterns.h"

#include "text.h"

#include <QCoreApplication>

namespace mirrorball::studio {

namespace {

void append(QStringList& patterns, const ImageFormat& format)
{
    for (const std::string_view extension : format.extensions)
        patterns << u'*' + toQString(extension);
}

} // namespace

QStringList imagePatterns()
{
    QStringList patterns;
    for (const ImageFormat& format : imageFormats())
        append(patterns, format);
    return patterns;
}

QStringList imagePatterns(Holding holding)
{
    QStringList patterns;
    for (const ImageFormat& format : imageFormats())
        if (format.write && (format.samples == StoredSamples::Byte) == (holding == Holding::Display))
            append(patterns, format);
    return patterns;
}

QString imageFilter() { return QCoreApplication::translate("ImagePatterns", "Images (%1);;All files (*)").arg(imagePatterns().join(u' ')); }

} // namespace mirrorball::studio
