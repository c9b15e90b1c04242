#include "preset_library.h"

#include "widgets/controls/text.h"
#include "widgets/picture/screen_picture.h"

#include "core/spheremap/evaluation/contact_sheet.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>

namespace mirrorball::studio {

namespace {

QImage ballOf(const SphereMapDocument& map, const JobControl& job)
{
    constexpr int size = 2 * PresetLibrary::pictureEdge;
    QImage picture = onScreen(cutToDisc(evaluate(map, {.size = size}, job)), job);
    picture.setDevicePixelRatio(2.0);
    return picture;
}

} // namespace

PresetLibrary::PresetLibrary(QObject* parent) : QAbstractListModel(parent)
{
    for (const auto presets : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& preset : presets)
            m_entries.push_back({.preset = &preset});
}

PresetLibrary::~PresetLibrary() = default;

int PresetLibrary::rowOf(const QString& name) const
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return toQString(e.preset->name) == name; });
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

int PresetLibrary::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(m_entries.size()); }

QVariant PresetLibrary::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Entry& entry = m_entries[static_cast<size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return fieldText(entry.preset->title);
    case Qt::DecorationRole:
        if (!entry.isAsked) // asking is no change that a view could see
            const_cast<PresetLibrary*>(this)->ask(index.row());
        return entry.picture.isNull() ? QVariant() : QVariant(entry.picture);
    case Qt::ToolTipRole:
        return fieldText(entry.preset->description);
    case Qt::AccessibleTextRole:
        return fieldText(entry.preset->title) + QStringLiteral(". ") + fieldText(entry.preset->description);
    case NameRole:
        return toQString(entry.preset->name);
    case SearchRole:
        return QStringList{toQString(entry.preset->name), fieldText(entry.preset->title), fieldText(entry.preset->description)}.join(u' ');
    default:
        return {};
    }
}

void PresetLibrary::ask(int row)
{
    m_entries[static_cast<size_t>(row)].isAsked = true;
    m_queue.push_back(row);
    if (!m_isMaking)
        makeNext();
}

void PresetLibrary::makeNext()
{
    m_isMaking = !m_queue.empty();
    if (!m_isMaking)
        return;
    const int row = m_queue.front();
    m_queue.pop_front();
    m_runner.start(
        [preset = m_entries[static_cast<size_t>(row)].preset](const JobControl& job) {
            JobControl one = job;
            one.threads = 1; // the picture and the maps come first
            return ballOf(preset->document, one);
        },
        [this, row](const QImage& picture) {
            m_entries[static_cast<size_t>(row)].picture = picture;
            emit dataChanged(index(row), index(row), {Qt::DecorationRole});
            makeNext();
        },
        Running::Finish);
}

} // namespace mirrorball::studio
