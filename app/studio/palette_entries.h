#pragma once

#include <QIcon>
#include <QMainWindow>
#include <QString>
#include <QVector>

#include <functional>

namespace mirrorball::studio {

/// One line of the command palette.
struct PaletteEntry {
    QString title; ///< "Edit: Undo orbit", "Material: Roughness"
    QString keys{};
    QString help{};
    QIcon icon{};
    std::function<void()> run;
};

/// Every command of a window's menus that can be run now.
QVector<PaletteEntry> commandEntries(const QMainWindow& window);
/// Every control of its docks that has a name and an effect now, shown there or behind a tab. Running one brings it to the front and gives
/// it the keys.
QVector<PaletteEntry> controlEntries(const QMainWindow& window);

/// Brings a control to the front: its dock, the tab it stands on, and the part of the dock that shows it; and gives it the keys.
void showControl(QWidget& control);

} // namespace mirrorball::studio
