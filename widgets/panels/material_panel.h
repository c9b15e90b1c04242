#pragma once

#include "widgets/controls/options_form.h"
#include "widgets/workspace/workspace.h"

#include <QScrollArea>

namespace mirrorball::studio {

/// The material of the scene: presets and files, the reflection, its levels, Fresnel term and curve, the diffuse part.
class MaterialPanel : public QWidget {
    Q_OBJECT

public:
    explicit MaterialPanel(Workspace& workspace, QWidget* parent = nullptr);

    OptionsForm& form() { return *m_form; }
    /// Takes the material of a material or scene file; what is wrong with it is told by a notice.
    void openMaterial(const QString& path);
    void saveMaterialAs(const QString& path);

private:
    QWidget* makePresetRow();
    QWidget* makeReplacedNote();
    void addReflection();
    void addBrdf();
    void addFresnel();
    void addDiffuse();
    void addClearCoat();
    void addNormalMap();
    void addLookup();
    void showPreset();

    Workspace& m_workspace;
    OptionsForm* m_form;
    QComboBox* m_presets = nullptr;
};

} // namespace mirrorball::studio
