#include "sphere_map_source_field.h"

#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/image_patterns.h"
#include "widgets/controls/text.h"
#include "widgets/panels/preset_gallery.h"

#include <QAction>
#include <QCompleter>
#include <QHBoxLayout>

namespace mirrorball::studio {

QString sphereMapFileFilter()
{
    return SphereMapSourceField::tr("Sphere maps and pictures of them (*.spheremap %1);;All files (*)").arg(imagePatterns().join(u' '));
}

SphereMapSourceField::SphereMapSourceField(PresetLibrary& library, QWidget* parent) : QWidget(parent), m_text(new QLineEdit)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_text);
    setFocusProxy(m_text);
    m_text->setPlaceholderText(tr("none"));
    QStringList names;
    for (int i = 0; i < library.rowCount(); ++i)
        names << library.index(i).data(PresetLibrary::NameRole).toString();
    auto* completer = new QCompleter(names, m_text);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    completer->setFilterMode(Qt::MatchContains);
    m_text->setCompleter(completer);

    const auto set = [this](const QString& source) {
        if (source != m_source)
            emit edited(source);
    };
    addFileButton(*m_text, {.purpose = QStringLiteral("open"), .title = tr("Choose a sphere map"), .filter = sphereMapFileFilter()}, set);
    QAction* preset = m_text->addAction(QIcon(QStringLiteral(":/icons/sphere-map.svg")), QLineEdit::TrailingPosition);
    preset->setObjectName(QStringLiteral("choosePreset"));
    preset->setToolTip(tr("Choose a preset"));
    connect(preset, &QAction::triggered, this,
            [this, &library, set] { connect(openPresetGallery(library, *this, m_source), &PresetGallery::chosen, this, set); });
    connect(m_text, &QLineEdit::editingFinished, this, [this, set] { set(m_text->text().trimmed()); });
}

SphereMapSourceField::~SphereMapSourceField() { disconnectChildren(*this); }

void SphereMapSourceField::setSource(const QString& source)
{
    m_source = source;
    if (m_text->text() != source)
        m_text->setText(source);
}

void SphereMapSourceField::describe(const QString& name, const QString& help)
{
    m_text->setAccessibleName(name);
    m_text->setToolTip(help);
    setAccessibleName(name);
    setToolTip(help);
}

} // namespace mirrorball::studio
