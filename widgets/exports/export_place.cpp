#include "export_place.h"

#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/file_dialogs.h"

#include <QClipboard>
#include <QDir>
#include <QFontDatabase>
#include <QGuiApplication>

namespace mirrorball::studio {

ExportPlace::ExportPlace(QWidget* parent) : QWidget(parent)
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    addFolderRow(*layout);
    addCommandRow(*layout);
}

ExportPlace::~ExportPlace() { disconnectChildren(*this); }

void ExportPlace::addFolderRow(QGridLayout& layout)
{
    m_folder = new QLineEdit;
    m_folder->setObjectName(QStringLiteral("export.folder"));
    m_folder->setAccessibleName(tr("Folder"));
    m_folder->setToolTip(tr("Where the files go; made when it is missing"));
    auto* label = new QLabel(tr("F&older"));
    label->setBuddy(m_folder);
    auto* browse = new QPushButton(tr("&Choose..."));
    browse->setObjectName(QStringLiteral("export.browse"));
    browse->setToolTip(tr("Chooses the folder"));
    browse->setAutoDefault(false);
    layout.addWidget(label, 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    layout.addWidget(m_folder, 0, 1);
    layout.addWidget(browse, 0, 2);
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString chosen = askForFolder(this, {.purpose = QStringLiteral("export"), .title = tr("Export into"), .start = folder()});
        if (!chosen.isEmpty())
            setFolder(chosen);
    });
    connect(m_folder, &QLineEdit::textChanged, this, &ExportPlace::folderChanged);
}

void ExportPlace::addCommandRow(QGridLayout& layout)
{
    m_command = new QLineEdit;
    m_command->setObjectName(QStringLiteral("export.command"));
    m_command->setReadOnly(true);
    m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_command->setAccessibleName(tr("Command line"));
    m_command->setToolTip(tr("Writes the same bytes without the studio"));
    auto* label = new QLabel(tr("Co&mmand line"));
    label->setBuddy(m_command);
    m_copy = new QPushButton(tr("Cop&y"));
    m_copy->setObjectName(QStringLiteral("export.copy"));
    m_copy->setToolTip(tr("Copies the command line"));
    m_copy->setAutoDefault(false);
    m_save = new QPushButton(tr("Sa&ve scene"));
    m_save->setObjectName(QStringLiteral("export.save"));
    m_save->setToolTip(tr("Saves the scene, which the command line reads"));
    m_save->setAutoDefault(false);
    layout.addWidget(label, 1, 0, Qt::AlignRight | Qt::AlignVCenter);
    layout.addWidget(m_command, 1, 1);
    layout.addWidget(m_copy, 1, 2);
    m_note = new QLabel;
    m_note->setWordWrap(true);
    m_note->setProperty("role", QStringLiteral("footnote"));
    layout.addWidget(m_note, 2, 1);
    layout.addWidget(m_save, 2, 2);
    connect(m_copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(m_command->text());
        emit copied();
    });
    connect(m_save, &QPushButton::clicked, this, &ExportPlace::saveRequested);
}

void ExportPlace::setFolder(const QString& folder) { m_folder->setText(QDir::toNativeSeparators(folder)); }

QString ExportPlace::folder() const
{
    const QString text = QDir::fromNativeSeparators(m_folder->text().trimmed());
    return text.isEmpty() ? text : QDir(text).absolutePath();
}

void ExportPlace::showCommand(const QString& command, SceneFile file, bool writesMaps)
{
    const bool isSaved = file == SceneFile::UpToDate;
    m_command->setText(command);
    m_command->setCursorPosition(0);
    m_command->setEnabled(isSaved);
    m_copy->setEnabled(isSaved && writesMaps);
    m_save->setVisible(!isSaved);
    m_note->setText(isSaved ? tr("Writes the same bytes as Export.")
                            : tr("The command line reads the saved scene: save it first, then both write the same bytes."));
}

} // namespace mirrorball::studio
