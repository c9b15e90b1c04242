#pragma once

#include "sphere_map_editor.h"
#include "widgets/controls/color_button.h"

#include <QMenu>
#include <QToolBar>

namespace mirrorball::studio {

/// The bar over the disc: what a press of the pen does and where, the brush's color, common symmetries. More can be put behind them.
class PaintTools : public QToolBar {
    Q_OBJECT

public:
    explicit PaintTools(SphereMapEditor& editor, QWidget* parent = nullptr);

signals:
    /// Symmetries other than the common ones are wanted.
    void moreSymmetriesWanted();

private:
    void addTools();
    void addColor();
    void addSymmetries();

    SphereMapEditor& m_editor;
};

} // namespace mirrorball::studio
