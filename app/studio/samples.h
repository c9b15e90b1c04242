#pragma once

#include <QString>
#include <QVector>

namespace mirrorball::studio {

/// A scene or a sphere map that comes with the program, to begin from.
struct Sample {
    QString file;  ///< "showroom.mirrorball"
    QString title; ///< "Showroom"
};
/// Scenes first.
QVector<Sample> samples();
/// A sample as a file of the user's, beside the others that it may name; written when it is not there or of another version.
/// @return empty where it cannot be written
QString samplePath(const QString& file);

} // namespace mirrorball::studio
