#pragma once

#include "file_kind.h"
#include "picture_use.h"

#include "widgets/workspace/workspace.h"

#include <QDateTime>
#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

namespace mirrorball::studio {

/// Opens whatever a path leads to: dialogs, drops, the command line and the list of recent files all end here.
class FileOpener : public QObject {
    Q_OBJECT

public:
    explicit FileOpener(Workspace& workspace, QObject* parent = nullptr);

    /// Opens a scene file, guarding unsaved changes. Without one, scenes are refused as what cannot be opened here.
    using OpenScene = std::function<bool(const QString& path)>;
    void setSceneOpener(OpenScene open) { m_openScene = std::move(open); }

    /// Asks what a square picture is; it calls usePicture() then, or does nothing. Without one such pictures are light probes.
    using AskForUse = std::function<void(const QString& path)>;
    void setQuestion(AskForUse ask) { m_ask = std::move(ask); }

    /// Opens paths one after the other. What cannot be opened is named by one notice.
    /// @param place  where they come to: it decides what a picture becomes
    void open(const QStringList& paths, DropPlace place = DropPlace::Elsewhere);
    /// What open() would do there, in a few words: "Light probe: sky.hdr".
    QString foretell(const QStringList& paths, DropPlace place);
    void usePicture(const QString& path, PictureUse use, const ProbeReading& reading = {});

signals:
    /// It is a part of the scene now, or the scene itself.
    void opened(const QString& path, mirrorball::studio::FileKind kind);

private:
    bool openOne(const QString& path, DropPlace place);
    void openPicture(const QString& path, DropPlace place);
    PictureFacts factsOf(const QString& path);

    /// The picture asked about last: while one hovers, every place asks what it would become, and a header may take the helper's start.
    struct KnownPicture {
        QString path;
        QDateTime modified;
        PictureFacts facts;
    };

    Workspace& m_workspace;
    OpenScene m_openScene{};
    AskForUse m_ask{};
    std::optional<KnownPicture> m_known{};
};

} // namespace mirrorball::studio
