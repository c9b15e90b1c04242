#pragma once

#include "sphere_map_editor.h"
#include "widgets/controls/settings_form.h"

#include <QWidget>

namespace mirrorball::studio {

/// What strokes are drawn with: the brush and the symmetry, field by field, and the stabilizer of the hand.
class BrushPage : public QWidget {
    Q_OBJECT

public:
    explicit BrushPage(SphereMapEditor& editor, QWidget* parent = nullptr);

private:
    void showBrush();

    SphereMapEditor& m_editor;
    SettingsForm *m_brush, *m_symmetry;
    NumberField* m_stabilizer;
};

} // namespace mirrorball::studio
