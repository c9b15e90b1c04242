#include "painted_export.h"

#include "widgets/controls/text.h"

#include "core/image/map_file.h"
#include "core/scene/scene_maps.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusTipEvent>

#include <array>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("sphere-map-picture");
const QString folderSetting = QStringLiteral("sphereMap/pictureFolder");

/// A kind of file, as the file dialog offers it.
struct Choice {
    QString filter;
    QString extension;
    PaintedLevels levels = PaintedLevels::One;
};

std::array<Choice, 5> choices()
{
    return {{{PaintedExport::tr("PNG, 8 bit (*.png)"), QStringLiteral(".png")},
             {PaintedExport::tr("OpenEXR, linear light (*.exr)"), QStringLiteral(".exr")},
             {PaintedExport::tr("OpenEXR with all mip levels (*.exr)"), QStringLiteral(".exr"), PaintedLevels::Authored},
             {PaintedExport::tr("TIFF, linear light (*.tif)"), QStringLiteral(".tif")},
             {PaintedExport::tr("TIFF with all mip levels (*.tif)"), QStringLiteral(".tif"), PaintedLevels::Authored}}};
}

/// "Cold and warm" gives Cold-and-warm.png: the title, where it makes a file name.
QString fileNameFor(const SphereMapSettings& map)
{
    QString name;
    for (const QChar letter : map.document ? toQString(map.document.document->title).simplified() : QString())
        name += letter.isLetterOrNumber() || letter == u'_' ? letter : u'-';
    return (name.isEmpty() ? QStringLiteral("matcap") : name) + QStringLiteral(".png");
}

} // namespace

PaintedExport::PaintedExport(Workspace& workspace, QWidget* window)
    : QObject(window), m_workspace(workspace), m_window(window), m_runner(this)
{
    connect(&m_runner, &JobRunner::failed, this,
            [this](const QString& message) { m_workspace.notices.set({.subject = noticeSubject, .text = message}); });
}

void PaintedExport::askAndWrite()
{
    QStringList filters;
    for (const Choice& choice : choices())
        filters << choice.filter;
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QDir folder(QSettings().value(folderSetting, pictures).toString());
    QString chosen = filters.front();
    QString path = QFileDialog::getSaveFileName(m_window, tr("Export the picture of the sphere map"),
                                                folder.filePath(fileNameFor(m_workspace.document.scene().material.sphereMap)),
                                                filters.join(QStringLiteral(";;")), &chosen);
    if (path.isEmpty())
        return;
    const Choice choice = choices()[static_cast<size_t>(std::max<qsizetype>(0, filters.indexOf(chosen)))];
    if (QFileInfo(path).suffix().isEmpty())
        path += choice.extension;
    QSettings().setValue(folderSetting, QFileInfo(path).absolutePath());
    write(path, choice.levels);
}

void PaintedExport::write(const QString& path, PaintedLevels levels)
{
    m_runner.start(
        [scene = m_workspace.document.scene(), file = toPath(path), levels](const JobControl& job) {
            const SphereMapSettings& map = scene.material.sphereMap;
            const SphereMapDocument document =
                sphereMapDocument(scene, {.field = "material.sphere_map.source", .source = map.source, .document = map.document});
            writePictures(file, paintedPictures(document, {.size = map.size, .levels = levels}, job),
                          paintedFileOptions(document, SampleType::Float));
            return file;
        },
        [this](const std::filesystem::path& file) {
            m_workspace.notices.clear(noticeSubject);
            QStatusTipEvent saved(tr("Saved %1").arg(fromPath(file)));
            QApplication::sendEvent(m_window, &saved);
            emit written(fromPath(file));
        },
        Running::Finish);
}

} // namespace mirrorball::studio
