#include "brush_page.h"

#include "widgets/controls/form_labels.h"

#include <QLabel>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

const FieldStyles brushStyles{
    {"mode", {.isHidden = true}},
    {"radius", {.sliderLow = 2e-3, .sliderHigh = 1.0, .scale = Scale::Logarithmic}},
    {"spacing", {.sliderLow = 0.02, .sliderHigh = 4.0, .scale = Scale::Logarithmic}},
};

} // namespace

BrushPage::BrushPage(SphereMapEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor)
{
    m_brush = new SettingsForm;
    m_brush->setObjectName(QStringLiteral("brushForm"));
    m_brush->build<Brush>(
        m_editor.brush(),
        [this](const QString&, const QString&, const std::function<void(Brush&)>& change) {
            Brush brush = m_editor.brush();
            change(brush);
            m_editor.setBrush(brush);
        },
        brushStyles);
    m_symmetry = new SettingsForm;
    m_symmetry->setObjectName(QStringLiteral("symmetryForm"));
    m_symmetry->build<Symmetry>(m_editor.symmetry(), [this](const QString&, const QString&, const std::function<void(Symmetry&)>& change) {
        Symmetry symmetry = m_editor.symmetry();
        change(symmetry);
        m_editor.setSymmetry(symmetry);
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 10, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_brush);
    auto* heading = new QLabel(tr("Symmetry"));
    heading->setProperty("role", QStringLiteral("heading"));
    column->addWidget(heading);
    column->addWidget(m_symmetry);
    auto* hint = new QLabel(tr("Right drag changes radius and hardness, [ and ] step the radius, Alt picks a color on the disc."));
    hint->setWordWrap(true);
    hint->setProperty("role", QStringLiteral("footnote"));
    column->addWidget(hint);
    column->addStretch(1);
    alignLabels(*this);
    connect(&m_editor, &SphereMapEditor::brushChanged, this, &BrushPage::showBrush);
    showBrush();
}

void BrushPage::showBrush()
{
    m_brush->show(m_editor.brush());
    m_symmetry->show(m_editor.symmetry());
}

} // namespace mirrorball::studio
