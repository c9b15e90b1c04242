#pragma once

#include "content_form.h"
#include "layer_list.h"
#include "mask_editor.h"
#include "widgets/controls/number_field.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QVector>

namespace mirrorball::studio {

/// The layers of the sphere map over the parameters of the chosen one.
class LayersPage : public QSplitter {
    Q_OBJECT

public:
    explicit LayersPage(SphereMapEditor& editor, QWidget* parent = nullptr);

    LayerList& list() { return *m_list; }
    SettingsForm& form() { return *m_form; }
    MaskEditor& mask() { return *m_mask; }

    /// The list is as high as its layers, as long as the parameters of the chosen one have room or half of the page; until the user divides
    /// it otherwise.
    void divide();

private:
    QWidget* makeTop();
    QLayout* makeBlendRow();
    QLayout* makeButtons();
    QWidget* makeParameters();
    QMenu* makeKindsMenu(QToolButton& button);
    void addLayer(const LayerKind& kind);
    void showLayer();

    SphereMapEditor& m_editor;
    bool m_isDivided = false; ///< by the user
    QWidget* m_top;           ///< the list with its buttons
    LayerList* m_list;
    QComboBox* m_blend;
    NumberField* m_opacity;
    QScrollArea* m_parameters;
    QLabel* m_note;
    ContentForm* m_form;
    MaskEditor* m_mask;
    size_t m_shownKind = SIZE_MAX;       ///< of the layer's content
    QVector<QWidget*> m_layerControls{}; ///< need a chosen layer
};

} // namespace mirrorball::studio
