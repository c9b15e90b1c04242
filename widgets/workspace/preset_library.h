#pragma once

#include "job_runner.h"

#include "core/spheremap/document/presets.h"

#include <QAbstractListModel>
#include <QImage>

#include <deque>
#include <vector>

namespace mirrorball::studio {

/// The built-in sphere maps, those for models first and then what may lie outside a window, as pictures of balls. A picture is made in the
/// background when a view first asks for it, the first one asked for first, and kept while the program runs: it takes less time than to
/// read one from disk.
class PresetLibrary : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        NameRole = Qt::UserRole, ///< QString as a scene names it: "jade"
        SearchRole,              ///< QString: all words that a search may look for
    };
    static constexpr int pictureEdge = 96; ///< of a picture on the screen; it is made for screens of up to twice the density

    explicit PresetLibrary(QObject* parent = nullptr);
    ~PresetLibrary() override;

    const SphereMapPreset& preset(int row) const { return *m_entries[static_cast<size_t>(row)].preset; }
    /// The row of a name, or -1.
    int rowOf(const QString& name) const;
    /// Whether pictures are being made.
    bool isBusy() const { return m_isMaking; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    struct Entry {
        const SphereMapPreset* preset = nullptr;
        QImage picture{}; ///< null before it is made
        bool isAsked = false;
    };

    void ask(int row);
    void makeNext();

    std::vector<Entry> m_entries;
    std::deque<int> m_queue;
    bool m_isMaking = false;
    JobRunner m_runner; ///< last: it ends first
};

} // namespace mirrorball::studio
