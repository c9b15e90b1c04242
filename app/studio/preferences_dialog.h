#pragma once

#include "command_keys.h"
#include "recovery.h"

#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

namespace mirrorball::studio {

/// How somebody works: keys of commands, what drags do in the picture, how soon unsaved changes are kept. Every change works at once and in
/// the next run; none is a part of a scene, and none is undone.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    PreferencesDialog(CommandKeys& keys, Recovery& recovery, QMainWindow& window);
    ~PreferencesDialog() override;

private:
    QWidget* makeKeys();
    QWidget* makeMouse(QMainWindow& window);
    QWidget* makeAutosave();
    void showCommands();
    void showKey();
    void takeKey();
    QAction* chosen() const;

    CommandKeys& m_keys;
    Recovery& m_recovery;
    QLineEdit* m_find;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_edit;
    QLabel* m_problem;
    QPushButton *m_reset, *m_none;
};

} // namespace mirrorball::studio
