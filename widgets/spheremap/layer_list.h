#pragma once

#include "sphere_map_editor.h"

#include <QAbstractListModel>
#include <QHash>
#include <QIcon>
#include <QListView>
#include <QPixmap>

#include <vector>

class QMenu;

namespace mirrorball::studio {

/// The layers of the sphere map as a list, the top one first.
class LayerModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { Visible = Qt::UserRole, Detail, Thumbnail };

    explicit LayerModel(SphereMapEditor& editor, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column, const QModelIndex& parent) override;

    /// Row of a layer, and back.
    int rowOf(int layer) const { return rowCount() - 1 - layer; }
    int layerOf(int row) const { return rowCount() - 1 - row; }

private:
    void follow();
    QPixmap thumbnail(size_t layer) const;

    SphereMapEditor& m_editor;
    int m_rows = 0;
    mutable std::vector<std::pair<LayerContent, QPixmap>> m_thumbnails{}; ///< by layer, while the content is the same
};

/// The list: click the eye to hide, double-click the name to rename, drag to reorder; Space hides, F2 renames, Delete removes, Ctrl and
/// arrows move the chosen layer.
class LayerList : public QListView {
    Q_OBJECT

public:
    explicit LayerList(SphereMapEditor& editor, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {260, 124}; }
    QSize minimumSizeHint() const override { return {120, 84}; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void showChosen();
    void toggle(const QModelIndex& index);
    void fillMenu(QMenu& menu);

    SphereMapEditor& m_editor;
    LayerModel* m_model;
};

} // namespace mirrorball::studio
