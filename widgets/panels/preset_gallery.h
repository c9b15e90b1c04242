#pragma once

#include "widgets/workspace/preset_library.h"

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSortFilterProxyModel>
#include <QWidget>

namespace mirrorball::studio {

/// The built-in sphere maps to choose from: balls with their names. Letters narrow the choice, arrows move in it, a click or Enter chooses;
/// the sentence below says what the one at hand is.
class PresetGallery : public QWidget {
    Q_OBJECT

public:
    explicit PresetGallery(PresetLibrary& library, QWidget* parent = nullptr);

    QLineEdit& find() { return *m_find; }
    QListView& list() { return *m_list; }
    /// Puts the cursor on a preset, if it is one.
    void point(const QString& name);

signals:
    void chosen(const QString& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void layOut();
    void choose(const QModelIndex& index);
    void explain(const QModelIndex& index);

    PresetLibrary& m_library;
    QSortFilterProxyModel m_filter;
    QLineEdit* m_find;
    QListView* m_list;
    QLabel* m_description;
};

/// Opens a gallery beside a widget; it closes when a preset is chosen, by Escape, or by a click elsewhere.
/// @param current  the preset that it begins at
/// @return the gallery, for its signal; it is gone when it is closed
PresetGallery* openPresetGallery(PresetLibrary& library, QWidget& beside, const QString& current = {});

} // namespace mirrorball::studio
