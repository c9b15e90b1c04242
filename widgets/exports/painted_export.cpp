#include "painted_export.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/text.h"

#include "core/image/image_format.h"
#include "core/scene/scene_maps.h"
#include "core/spheremap/evaluation/painted_files.h"

#include <QApplication>
#include <QFileInfo>
#include <QStatusTipEvent>

#include <vector>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("sphere-map-picture");

/// A kind of file, as the file dialog offers it.
struct Choice {
    QString filter;
    QString extension;
    PaintedLevels levels = PaintedLevels::One;
};

/// Pictures to look at first, since that is what most programs take.
std::vector<Choice> choices()
{
    std::vector<Choice> shown, linear;
    for (const ImageFormat& format : imageFormats()) {
        if (!format.write)
            continue;
        const QString label = toQString(format.label), extension = toQString(format.extensions.front());
        if (format.samples == StoredSamples::Byte)
            shown.push_back({PaintedExport::tr("%1, 8 bit (*%2)").arg(label, extension), extension});
        else
            linear.push_back({PaintedExport::tr("%1, linear light (*%2)").arg(label, extension), extension});
        if (format.levels)
            linear.push_back({PaintedExport::tr("%1 with all mip levels (*%2)").arg(label, extension), extension, PaintedLevels::Authored});
    }
    shown.insert(shown.end(), linear.begin(), linear.end());
    return shown;
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
    const SaveAnswer answer = askWhereToSave(m_window, {.purpose = QStringLiteral("export-picture"),
                                                        .title = tr("Export the picture of the sphere map"),
                                                        .filter = filters.join(QStringLiteral(";;")),
                                                        .start = fileNameFor(m_workspace.document.scene().material.sphereMap)});
    if (answer.path.isEmpty())
        return;
    const Choice choice = choices()[static_cast<size_t>(std::max<qsizetype>(0, filters.indexOf(answer.filter)))];
    const QString path = QFileInfo(answer.path).suffix().isEmpty() ? answer.path + choice.extension : answer.path;
    write(path, choice.levels);
}

void PaintedExport::write(const QString& path, PaintedLevels levels)
{
    m_runner.start(
        [scene = m_workspace.document.scene(), file = toPath(path), levels](const JobControl& job) {
            const SphereMapSettings& map = scene.material.sphereMap;
            const SphereMapDocument document =
                sphereMapDocument(scene, {.field = "material.sphere_map.source", .source = map.source, .document = map.document});
            writePainted(file, document, {.size = map.size, .levels = levels}, SampleType::Float, job);
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
