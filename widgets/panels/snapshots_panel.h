#pragma once

#include "widgets/workspace/workspace.h"

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

namespace mirrorball::studio {

/// The snapshots with their thumbnails and names: which is A, how it is compared with what is shown now, how far that is from it.
class SnapshotsPanel : public QWidget {
    Q_OBJECT

public:
    explicit SnapshotsPanel(Workspace& workspace, QWidget* parent = nullptr);

private:
    QWidget* makeButtons();
    QPushButton* addButton(const char* name, const QString& text, const QString& help);
    void showList();
    void showComparison();
    void bringBack();
    void removeChosen();

    Workspace& m_workspace;
    QListWidget* m_list;
    QComboBox* m_compare;
    QLabel* m_figures;
    QPushButton *m_back, *m_rename, *m_remove;
};

} // namespace mirrorball::studio
