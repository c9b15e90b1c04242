#pragma once

#include "widgets/controls/options_form.h"
#include "widgets/workspace/workspace.h"

#include "core/preview/display_transform.h"

namespace mirrorball::studio {

/// How the picture is taken: geometry, camera, background, display, and the environment's turn and brightness.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ViewPanel(Workspace& workspace, QWidget* parent = nullptr);
    OptionsForm& form() { return *m_form; }
    /// Displays through an OpenColorIO configuration, at first by its own choice of display and view.
    void openDisplayConfig(const QString& path);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addGeometry();
    /// The bodies' small pictures, which are asked for only while somebody sees the list.
    void showBodyPictures();
    void addWindow();
    void addDisplay();
    void setDisplay(DisplaySettings display);
    void showDisplay(const Scene& scene);
    void offer(const std::string& config, const std::vector<preview::DisplayOffer>& offers);

    Workspace& m_workspace;
    OptionsForm* m_form;
    QComboBox* m_bodies = nullptr; ///< the mesh file last
    QComboBox* m_displays = nullptr;
    JobRunner m_offers;    ///< reads what a configuration offers
    std::string m_offered; ///< that configuration
};

/// Shows the material on another body: "teapot", "window", ... The camera goes where it is at first, if it was there before, and always
/// into the room of the window, which gets something to look at where the scene has no sphere map.
void useGeometry(Scene& scene, const std::string& geometry);

} // namespace mirrorball::studio
