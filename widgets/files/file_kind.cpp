#include "file_kind.h"

#include "widgets/controls/image_patterns.h"
#include "widgets/controls/text.h"

#include "core/preview/mesh_file.h"
#include "core/scene/scene.h"
#include "core/spheremap/document/sphere_map_document.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>

#include <algorithm>
#include <array>

namespace mirrorball::studio {

namespace {

constexpr qint64 headBytes = 64 << 10; ///< of a file: what tells its kind comes first
constexpr std::array kinds{FileKind::Scene, FileKind::Material, FileKind::SphereMap, FileKind::Mesh, FileKind::Picture, FileKind::Display};

struct KindWords {
    FileKind kind;
    const char* word;
    const char* text; ///< of one
    const char* list; ///< of many, in the filter of a dialog
};
constexpr std::array kindWords{
    KindWords{FileKind::Scene, "scene", QT_TRANSLATE_NOOP("FileKind", "scene"), QT_TRANSLATE_NOOP("FileKind", "Scenes")},
    KindWords{FileKind::Material, "material", QT_TRANSLATE_NOOP("FileKind", "material"), QT_TRANSLATE_NOOP("FileKind", "Materials")},
    KindWords{FileKind::SphereMap, "sphere-map", QT_TRANSLATE_NOOP("FileKind", "sphere map"), QT_TRANSLATE_NOOP("FileKind", "Sphere maps")},
    KindWords{FileKind::Mesh, "mesh", QT_TRANSLATE_NOOP("FileKind", "mesh"), QT_TRANSLATE_NOOP("FileKind", "Meshes")},
    KindWords{FileKind::Picture, "picture", QT_TRANSLATE_NOOP("FileKind", "picture"),
              QT_TRANSLATE_NOOP("FileKind", "Light probes and pictures")},
    KindWords{FileKind::Display, "display", QT_TRANSLATE_NOOP("FileKind", "OpenColorIO configuration"),
              QT_TRANSLATE_NOOP("FileKind", "OpenColorIO configurations")},
    KindWords{FileKind::Folder, "folder", QT_TRANSLATE_NOOP("FileKind", "folder"), QT_TRANSLATE_NOOP("FileKind", "Folders")},
};

const KindWords* wordsOf(FileKind kind)
{
    const auto found = std::find_if(kindWords.begin(), kindWords.end(), [&](const KindWords& w) { return w.kind == kind; });
    return found == kindWords.end() ? nullptr : &*found;
}

FileKind byEnding(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    for (const FileKind kind : kinds)
        if (QDir::match(patternsOf(kind), name))
            return kind;
    return FileKind::Unknown;
}

bool isPicture(const QByteArray& head)
{
    const std::string_view bytes(head.constData(), static_cast<size_t>(head.size()));
    for (const ImageFormat& format : imageFormats())
        if (format.recognizes && format.recognizes(bytes))
            return true;
    // Of formats that OpenImageIO knows by more than these; others go by their endings.
    using namespace std::string_view_literals;
    for (const std::string_view signature : {"\x89PNG\r\n\x1a\n"sv, "\xff\xd8\xff"sv, "II*\0"sv, "MM\0*"sv, "8BPS"sv})
        if (bytes.starts_with(signature))
            return true;
    return bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP");
}

/// The keys of the outermost object, as far as they are in the beginning of a JSON text; none where it is no object.
QSet<QString> outermostKeys(const QByteArray& text)
{
    QSet<QString> keys;
    int depth = 0;
    bool isKeyNext = false;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (depth == 0 && c != '{') {
            if (!QChar::isSpace(static_cast<uchar>(c)))
                return {};
        } else if (c == '"') {
            const qsizetype first = i + 1;
            for (++i; i < text.size() && text[i] != '"'; ++i)
                if (text[i] == '\\')
                    ++i;
            if (depth == 1 && isKeyNext && i < text.size())
                keys.insert(QString::fromUtf8(text.mid(first, i - first)));
            isKeyNext = false;
        } else if (c == '{' || c == '[') {
            isKeyNext = ++depth == 1;
        } else if (c == '}' || c == ']') {
            if (--depth == 0)
                break;
        } else if (c == ',') {
            isKeyNext = depth == 1;
        }
    }
    return keys;
}

template <typename Settings>
bool hasFieldOf(const QSet<QString>& keys)
{
    bool has = false;
    const Settings initial;
    Settings::visitFields(initial, [&](const Field& field, const auto&) { has = has || keys.contains(toQString(field.name)); });
    return has;
}

/// The kind of a JSON file by its keys; each kind has some that the others before it have not.
FileKind byKeys(const QSet<QString>& keys)
{
    if (keys.contains(QStringLiteral("asset"))) // glTF asks for it
        return FileKind::Mesh;
    if (keys.contains(QStringLiteral("layers")) || keys.contains(QStringLiteral("strokes")))
        return FileKind::SphereMap;
    if (hasFieldOf<Scene>(keys))
        return FileKind::Scene;
    return hasFieldOf<Material>(keys) ? FileKind::Material : FileKind::Unknown;
}

} // namespace

FileKind fileKind(const QString& path)
{
    if (QFileInfo(path).isDir())
        return FileKind::Folder;
    QFile file(path);
    if (!file.open(QFile::ReadOnly))
        return byEnding(path);
    const QByteArray head = file.read(headBytes);
    if (isPicture(head))
        return FileKind::Picture;
    if (head.startsWith("ocio_profile_version"))
        return FileKind::Display;
    if (const FileKind kind = byKeys(outermostKeys(head)); kind != FileKind::Unknown)
        return kind;
    return byEnding(path);
}

QString kindText(FileKind kind)
{
    const KindWords* words = wordsOf(kind);
    return words ? QCoreApplication::translate("FileKind", words->text) : QString();
}

QString kindWord(FileKind kind)
{
    const KindWords* words = wordsOf(kind);
    return words ? QLatin1String(words->word) : QString();
}

FileKind kindOfWord(const QString& word)
{
    for (const KindWords& words : kindWords)
        if (word == QLatin1String(words.word))
            return words.kind;
    return FileKind::Unknown;
}

QStringList patternsOf(FileKind kind)
{
    switch (kind) {
    case FileKind::Scene:
        return {QStringLiteral("*.mirrorball")};
    case FileKind::Material:
        return {QStringLiteral("*.material"), QStringLiteral("*.json")};
    case FileKind::SphereMap:
        return {QStringLiteral("*.spheremap"), QStringLiteral("*.strokes")};
    case FileKind::Mesh: {
        QStringList patterns;
        for (const std::string_view extension : preview::meshExtensions())
            patterns << u'*' + toQString(extension);
        return patterns;
    }
    case FileKind::Picture:
        return imagePatterns();
    case FileKind::Display:
        return {QStringLiteral("*.ocio")};
    case FileKind::Folder:
    case FileKind::Unknown:
        break;
    }
    return {};
}

QString filterOf(FileKind kind)
{
    const KindWords* words = wordsOf(kind);
    return QStringLiteral("%1 (%2);;%3")
        .arg(words ? QCoreApplication::translate("FileKind", words->list) : QString(), patternsOf(kind).join(u' '),
             QCoreApplication::translate("FileKind", "All files (*)"));
}

QString openFilter()
{
    QStringList all, lines;
    for (const FileKind kind : kinds) {
        all << patternsOf(kind);
        lines << filterOf(kind).section(QStringLiteral(";;"), 0, 0);
    }
    lines.prepend(QCoreApplication::translate("FileKind", "Everything that can be opened (%1)").arg(all.join(u' ')));
    lines << QCoreApplication::translate("FileKind", "All files (*)");
    return lines.join(QStringLiteral(";;"));
}

} // namespace mirrorball::studio
