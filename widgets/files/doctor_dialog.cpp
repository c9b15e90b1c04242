#include "doctor_dialog.h"

#include "file_kind.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/text.h"

#include "core/doctor/diagnosis.h"
#include "core/image/probe_file.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

QString examined(const QString& path, const QString& source, const JobControl& job)
{
    const StoredMap map = readStoredMap(toPath(path).string(), {}, job);
    std::optional<EnvironmentMap> probe;
    if (!source.isEmpty())
        probe = readProbe(source.toStdString(), {}, job).map;
    Diagnosis diagnosis = diagnose(map, probe, {}, job);
    diagnosis.map = path.toStdString();
    diagnosis.probe = source.toStdString();
    return toQString(diagnosisText(diagnosis));
}

} // namespace

DoctorDialog::DoctorDialog(Workspace& workspace, const QString& map, QWidget* parent)
    : QDialog(parent), m_map(map), m_source(new QComboBox), m_text(new QPlainTextEdit), m_progress(new QProgressBar), m_runner(this)
{
    setObjectName(QStringLiteral("doctor"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("What is this map? - %1").arg(QFileInfo(map).fileName()));
    resize(720, 520);

    m_source->setObjectName(QStringLiteral("doctor.source"));
    m_source->setAccessibleName(tr("Made from"));
    m_source->setToolTip(tr("The light probe that the map was filtered from: with it the doctor measures orientation and errors"));
    m_source->addItem(tr("not known"), QString());
    const QString source = toQString(resolved(workspace.document.scene(), workspace.document.scene().probe.source));
    if (QFileInfo(source) != QFileInfo(map)) // it may have become the probe itself
        m_source->addItem(tr("the scene's probe, %1").arg(QFileInfo(source).fileName()), source);
    m_source->addItem(tr("Choose a file…"));
    connect(m_source, &QComboBox::activated, this, &DoctorDialog::chooseSource);

    m_text->setReadOnly(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setAccessibleName(tr("What the doctor says"));
    m_text->setToolTip(tr("What the map is, and what is wrong with it; the command \"doctor\" says the same"));
    m_text->setPlaceholderText(tr("The map is examined…"));
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(4);
    m_progress->setAccessibleName(tr("Progress"));

    auto* from = new QHBoxLayout;
    auto* label = new QLabel(tr("&Made from"));
    label->setBuddy(m_source);
    from->addWidget(label);
    from->addWidget(m_source, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copies the words"));
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(from);
    column->addWidget(m_text, 1);
    column->addWidget(m_progress);
    column->addWidget(buttons);

    connect(&m_runner, &JobRunner::failed, m_text, &QPlainTextEdit::setPlainText);
    connect(&m_runner, &JobRunner::busyChanged, m_progress, &QWidget::setVisible);
    connect(&m_runner, &JobRunner::progressed, this, [this](double fraction) { m_progress->setValue(static_cast<int>(100 * fraction)); });
    examine();
}

void DoctorDialog::chooseSource()
{
    if (m_source->currentIndex() == m_source->count() - 1) {
        const QString path = askForFile(
            this, {.purpose = QStringLiteral("open"), .title = tr("What the map was made from"), .filter = filterOf(FileKind::Picture)});
        if (path.isEmpty()) {
            m_source->setCurrentIndex(0);
        } else {
            m_source->insertItem(m_source->count() - 1, QFileInfo(path).fileName(), path);
            m_source->setCurrentIndex(m_source->count() - 2);
        }
    }
    examine();
}

void DoctorDialog::examine()
{
    m_text->clear();
    m_runner.start([map = m_map, source = m_source->currentData().toString()](const JobControl& job) { return examined(map, source, job); },
                   [this](const QString& words) { m_text->setPlainText(words); });
}

} // namespace mirrorball::studio
