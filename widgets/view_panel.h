#pragma once

#include "options_form.h"
#include "workspace.h"

namespace mirrorball::studio {

/// How the picture is taken: geometry, camera, background, display, and the environment's turn and brightness.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ViewPanel(Workspace& workspace, QWidget* parent = nullptr);
    OptionsForm& form() { return *m_form; }

private:
    void addGeometry();

    Workspace& m_workspace;
    OptionsForm* m_form;
};

/// Opens a mesh file as the geometry of the scene.
void useMesh(Document& document, const QString& path);

} // namespace mirrorball::studio
