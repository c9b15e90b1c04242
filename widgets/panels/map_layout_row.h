#pragma once

#include "widgets/workspace/document.h"

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>

#include <optional>

namespace mirrorball::studio {

/// The layout of the scene's map, each change an undo step, and the parameterization that it is compared with, which is no part of the
/// scene.
class MapLayoutRow : public QWidget {
    Q_OBJECT

public:
    explicit MapLayoutRow(Document& document, QWidget* parent = nullptr);

    /// The parameterization that is shown beside the scene's; nothing: the map stands alone.
    std::optional<Parameterization> compared() const;

signals:
    void comparedChanged();

private:
    void arrange();
    void readScene();

    Document& m_document;
    QComboBox *m_kind, *m_compare;
    QSpinBox *m_size, *m_border;
    QLabel* m_borderLabel;
};

} // namespace mirrorball::studio
