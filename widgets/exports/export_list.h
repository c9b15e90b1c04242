#pragma once

#include "widgets/workspace/document.h"

#include "core/scene/export_estimate.h"

#include <QAction>
#include <QPushButton>
#include <QStringList>
#include <QTreeWidget>
#include <QWidget>

#include <string>
#include <vector>

namespace mirrorball::studio {

/// The maps that a scene exports: which there are, each change an undo step of the document, which of them are to be written now, and what
/// each will take on disk.
class ExportList : public QWidget {
    Q_OBJECT

public:
    explicit ExportList(Document& document, QWidget* parent = nullptr);
    ~ExportList() override;

    /// The selected map; null where there is none.
    const ExportTarget* selected() const;
    /// Its place among the scene's exports, or -1.
    int selectedRow() const;
    void selectRow(int row);
    /// Names of the maps that are to be written now.
    std::vector<std::string> checkedNames() const;

    void add(ExportKind kind);
    void duplicateSelected();
    void removeSelected();

    /// Lists the scene's exports anew.
    void readScene();
    /// Whether a sphere map can be added: where the scene has one.
    void offerPainted(bool hasMap);
    void showEstimates(const std::vector<ExportEstimate>& estimates);

signals:
    /// selected() may be another one now, or another value.
    void selectionShown();
    void checksChanged();
    void added();

private:
    void makeTree();
    QLayout* makeButtons();
    void showSelection();

    Document& m_document;
    QTreeWidget* m_tree;
    QAction* m_addPainted;
    QPushButton *m_duplicate, *m_remove;
    QStringList m_unchecked; ///< names of targets that are not to be written now
};

} // namespace mirrorball::studio
