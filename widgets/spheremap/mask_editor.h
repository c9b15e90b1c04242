#pragma once

#include "content_form.h"
#include "sphere_map_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>

namespace mirrorball::studio {

/// Where the chosen layer shows: its mask, which is any generator or painted by hand, and the levels of a hand-made chain it takes part in.
class MaskEditor : public QWidget {
    Q_OBJECT

public:
    explicit MaskEditor(SphereMapEditor& editor, QWidget* parent = nullptr);

    /// What the mask is: "None", then the generators. Choosing one gives the layer such a mask.
    QComboBox& kinds() { return *m_kinds; }
    ContentForm& form() { return *m_form; }
    QToolButton& paintButton() { return *m_paint; }

private:
    void makeMask();     ///< which it is, and what of it counts
    void makeControls(); ///< of what it shows
    void makeLevels();
    void layOut();
    void follow();
    void chooseKind(int index);

    SphereMapEditor& m_editor;
    QComboBox* m_kinds;
    QComboBox* m_channel;
    QCheckBox* m_invert;
    QToolButton* m_paint;
    ContentForm* m_form;
    QWidget* m_details; ///< of a mask
    QSpinBox* m_firstLevel;
    QSpinBox* m_lastLevel;
};

} // namespace mirrorball::studio
