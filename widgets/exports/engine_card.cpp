#include "engine_card.h"

#include "widgets/controls/text.h"

#include "core/scene/export_estimate.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

QLabel* wrappedLabel(const char* name, const QString& accessibleName)
{
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setAccessibleName(accessibleName);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

QString contentText(EngineContent content)
{
    switch (content) {
    case EngineContent::Latlong:
        return EngineCard::tr("environment, latlong");
    case EngineContent::Skybox:
        return EngineCard::tr("environment, cube");
    case EngineContent::SpecularCube:
        return EngineCard::tr("specular levels, cube");
    case EngineContent::DiffuseCube:
        return EngineCard::tr("diffuse light, cube");
    case EngineContent::BabylonEnv:
        return EngineCard::tr("specular levels and diffuse light");
    case EngineContent::Atlas:
        return EngineCard::tr("specular levels and diffuse light, atlas");
    case EngineContent::Sh:
        return EngineCard::tr("diffuse light, nine coefficients");
    case EngineContent::Text:
        return EngineCard::tr("what loads or describes them");
    }
    return {};
}

} // namespace

QString provenText(const EngineProfile& profile)
{
    return profile.proven.empty() ? EngineCard::tr("not proven: written from its sources, it cannot run in the tests")
                                  : EngineCard::tr("proven in %1").arg(toQString(profile.proven));
}

EngineCard::EngineCard(QWidget* parent) : QWidget(parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    m_title = wrappedLabel("engine.title", tr("Engine"));
    QFont large = m_title->font();
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    m_title->setFont(large);
    m_proven = wrappedLabel("engine.proven", tr("Proof"));
    m_how = wrappedLabel("engine.how", tr("What the engine does with the files"));
    m_notes = wrappedLabel("engine.notes", tr("Warnings and notes"));
    m_size = new QComboBox;
    m_size->setObjectName(QStringLiteral("engine.size"));
    m_size->setAccessibleName(tr("Size"));
    m_size->setToolTip(tr("Edge of the largest cube face; an engine that filters by itself gets the probe at its own size"));
    auto* sizeLabel = new QLabel(tr("&Size"));
    sizeLabel->setBuddy(m_size);
    m_files = new QTreeWidget;
    m_files->setObjectName(QStringLiteral("engine.files"));
    m_files->setAccessibleName(tr("Files that will be written"));
    m_files->setRootIsDecorated(false);
    m_files->setSelectionMode(QAbstractItemView::NoSelection);
    m_files->setHeaderLabels({tr("File"), tr("Holds"), tr("Texels"), tr("Levels"), tr("Bytes")});
    m_files->header()->setStretchLastSection(false);
    m_files->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_files->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_files->setToolTip(tr("Files that will be written; levels show their roughness when pointed at"));
    auto* sizeRow = new QHBoxLayout;
    sizeRow->addWidget(sizeLabel);
    sizeRow->addWidget(m_size);
    sizeRow->addStretch(1);
    layout->addWidget(m_title);
    layout->addWidget(m_proven);
    layout->addWidget(m_how);
    layout->addLayout(sizeRow);
    layout->addWidget(m_files, 1);
    layout->addWidget(m_notes);
    connect(m_size, &QComboBox::activated, this, &EngineCard::sizeChanged);
}

void EngineCard::show(const EngineProfile& profile)
{
    m_title->setText(toQString(profile.title));
    m_proven->setText(provenText(profile));
    m_how->setText(toQString(profile.how));
    m_note = toQString(profile.note);
    m_notes->setText(m_note);
    const QSignalBlocker blocker(m_size);
    m_size->clear();
    if (!profile.law) {
        m_size->addItem(tr("as the probe"), 0);
    } else {
        for (int size = profile.smallest; size <= profile.largest; size *= 2)
            m_size->addItem(QString::number(size), size == profile.size ? 0 : size);
        m_size->setCurrentIndex(m_size->findData(0));
    }
    m_size->setEnabled(m_size->count() > 1);
    m_files->clear();
}

void EngineCard::showEstimate(const EngineEstimate& estimate)
{
    m_files->clear();
    for (const EngineFilePlan& file : estimate.files) {
        auto* item =
            new QTreeWidgetItem({toQString(file.file), contentText(file.content), file.size > 0 ? QString::number(file.size) : QString(),
                                 file.levels > 0 ? QString::number(file.levels) : QString(), toQString(byteText(file.bytes))});
        QStringList roughness;
        for (const double r : file.roughness)
            roughness << QString::number(r, 'f', 2);
        if (!roughness.isEmpty())
            item->setToolTip(3, tr("Roughness of the levels: %1").arg(roughness.join(QStringLiteral(", "))));
        for (const int column : {2, 3, 4})
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        m_files->addTopLevelItem(item);
    }
    QStringList notes;
    for (const std::string& warning : estimate.warnings)
        notes << toQString(warning);
    if (!m_note.isEmpty())
        notes << m_note;
    m_notes->setText(notes.join(QLatin1Char('\n')));
}

void EngineCard::showProblem(const QString& message)
{
    m_files->clear();
    m_notes->setText(message);
}

int EngineCard::size() const { return m_size->currentData().toInt(); }

} // namespace mirrorball::studio
