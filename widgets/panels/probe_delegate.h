#pragma once

#include "widgets/workspace/probe_watcher.h"

#include <QStyledItemDelegate>

namespace mirrorball::studio {

/// A probe of a ProbeLibrary as a card: its picture, its name, and what it is. The one that lights the scene stands out.
class ProbeDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    /// @param watcher  knows the scene's probe
    explicit ProbeDelegate(const ProbeWatcher& watcher, QObject* parent) : QStyledItemDelegate(parent), m_watcher(watcher) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const ProbeWatcher& m_watcher;
};

} // namespace mirrorball::studio
