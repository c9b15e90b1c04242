#pragma once

#include <QString>
#include <QStringList>

/// What the studio can open. The one place where that is decided.
namespace mirrorball::studio {

enum class FileKind {
    Scene,
    Material,
    SphereMap, ///< a document of layers, or recorded strokes
    Mesh,
    Picture, ///< a light probe, a picture of a ball, a texture container
    Display, ///< an OpenColorIO configuration
    Folder,
    Unknown,
};

/// What a path is: by its first bytes where they say it, so that a wrong or missing ending does no harm; else by its ending. A path with a
/// `%s` stands for the pictures of the six faces of a cube. A path that leads nowhere is what its ending says.
FileKind fileKind(const QString& path);

/// "scene", "light probe or picture", in the user's language.
QString kindText(FileKind kind);
/// The word that settings keep: "scene", "sphere-map"; and back: Unknown where it is none.
QString kindWord(FileKind kind);
FileKind kindOfWord(const QString& word);

/// The endings of a kind as patterns: "*.mirrorball".
QStringList patternsOf(FileKind kind);
/// What a dialog that opens anything shows: all that can be opened first, then kind by kind, then all files.
QString openFilter();
/// The same for one kind, and all files.
QString filterOf(FileKind kind);

} // namespace mirrorball::studio
