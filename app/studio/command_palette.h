#pragma once

#include "palette_entries.h"

#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

namespace mirrorball::studio {

/// Finds by what is typed: every action of the window's menus, with its shortcut beside it, and every control of its docks. Enter runs the
/// one and goes to the other.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    /// @param window whose actions and controls are offered
    explicit CommandPalette(QMainWindow& window);

    QLineEdit& input() { return *m_input; }
    QListWidget& list() { return *m_list; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& typed);
    void run();

    QLineEdit* m_input;
    QListWidget* m_list;
    QVector<PaletteEntry> m_entries;
};

/// Whether the letters of `typed` occur in `text` in their order, and how well: 0 is not at all, a run of letters and the start of a word
/// count more.
int matchScore(const QString& typed, const QString& text);

} // namespace mirrorball::studio
