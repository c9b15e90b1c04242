#include "paint_tools.h"

#include "widgets/controls/icon_button.h"

#include <QActionGroup>

namespace mirrorball::studio {

PaintTools::PaintTools(SphereMapEditor& editor, QWidget* parent) : QToolBar(parent), m_editor(editor)
{
    setIconSize({20, 20});
    addTools();
    addSeparator();
    addColor();
    addSymmetries();
}

void PaintTools::addTools()
{
    auto* tools = new QActionGroup(this);
    const auto addTool = [&](const char* iconName, const QString& name, const QString& help, PaintTool tool) {
        QAction* action = addAction(iconOf(iconName), name);
        action->setToolTip(help);
        action->setCheckable(true);
        action->setData(static_cast<int>(tool));
        tools->addAction(action);
        connect(action, &QAction::triggered, this, [this, tool] { m_editor.setTool(tool); });
    };
    addTool("brush", tr("Paint"), tr("Paint. A pen's pressure and its tilt count; its eraser end erases"), PaintTool::Paint);
    addTool("eraser", tr("Erase"), tr("Erase what was painted on this layer"), PaintTool::Erase);
    addTool("smudge", tr("Smudge"), tr("Push what was painted on this layer"), PaintTool::Smudge);
    addTool("eyedropper", tr("Pick a color"), tr("Pick a color from the map; Alt does it with every tool"), PaintTool::PickColor);
    addSeparator();
    QAction* onModel = addAction(iconOf("paint-model"), tr("Paint on the model"));
    onModel->setObjectName(QStringLiteral("paintOnModel"));
    onModel->setToolTip(tr("Paint on the model in the preview; Alt and left drag then turns it"));
    onModel->setCheckable(true);
    connect(onModel, &QAction::toggled, &m_editor, &SphereMapEditor::setPaintsOnModel);
    const auto showTool = [this, onModel, tools] {
        onModel->setChecked(m_editor.paintsOnModel());
        for (QAction* action : tools->actions())
            action->setChecked(action->data().toInt() == static_cast<int>(m_editor.tool()));
    };
    connect(&m_editor, &SphereMapEditor::toolChanged, this, showTool);
    showTool();
}

void PaintTools::addColor()
{
    auto* color = new ColorButton;
    color->setMinimumWidth(44);
    color->setAccessibleName(tr("Brush color"));
    color->setToolTip(tr("Color of the paint"));
    connect(color, &ColorButton::edited, this, [this](const glm::dvec3& chosen) {
        Brush brush = m_editor.brush();
        brush.color = chosen;
        m_editor.setBrush(brush);
    });
    addWidget(color);
    const auto showColor = [this, color] { color->setColor(m_editor.brush().color); };
    connect(&m_editor, &SphereMapEditor::brushChanged, color, showColor);
    showColor();
}

void PaintTools::addSymmetries()
{
    auto* symmetry = iconButton("symmetry", tr("Symmetry"), tr("Repeat strokes around the center, or mirror them"));
    symmetry->setObjectName(QStringLiteral("symmetryButton"));
    symmetry->setPopupMode(QToolButton::InstantPopup);
    auto* choices = new QMenu(symmetry);
    const auto addSymmetry = [&](const QString& name, const Symmetry& wanted) {
        connect(choices->addAction(name), &QAction::triggered, this, [this, wanted] { m_editor.setSymmetry(wanted); });
    };
    addSymmetry(tr("None"), {});
    addSymmetry(tr("Mirror left and right"), {.mirror = true, .axisDeg = 90.0});
    addSymmetry(tr("Mirror top and bottom"), {.mirror = true, .axisDeg = 0.0});
    addSymmetry(tr("Mirror both ways"), {.radial = 2, .mirror = true, .axisDeg = 90.0});
    choices->addSeparator();
    for (const int turns : {3, 4, 6, 8, 12, 24})
        addSymmetry(tr("%1 times around").arg(turns), {.radial = turns});
    choices->addSeparator();
    connect(choices->addAction(tr("More...")), &QAction::triggered, this, &PaintTools::moreSymmetriesWanted);
    symmetry->setMenu(choices);
    addWidget(symmetry);
}

} // namespace mirrorball::studio
