#pragma once

#include "probe_details.h"
#include "probe_filter.h"
#include "widgets/workspace/probe_watcher.h"
#include "widgets/workspace/workspace.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QWidget>

namespace mirrorball::studio {

/// The Probes dock: thumbnails to choose from, facts of the chosen probe, and how it is read.
class ProbesPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProbesPanel(Workspace& workspace, QWidget* parent = nullptr);

    QListView& list() { return *m_list; }
    ProbeDetails& details() { return *m_details; }

    QSize sizeHint() const override { return {320, 560}; }

private:
    QWidget* makeGroupRow();
    void listGroups();
    QString removableFile() const;
    void removeFile();
    void choose(const QModelIndex& index);
    void showMenu(const QPoint& position);
    void markChosen();
    void showEmptiness();

    Workspace& m_workspace;
    ProbeWatcher m_watcher;
    ProbeFilter m_filter;
    QComboBox* m_group;
    QLineEdit* m_find;
    QListView* m_list;
    QLabel* m_empty;
    ProbeDetails* m_details;
};

} // namespace mirrorball::studio
