#include "brush_page.h"

#include "widgets/controls/field_label.h"
#include "widgets/controls/form_labels.h"

#include <QFormLayout>
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
    m_stabilizer =
        new NumberField({.high = longestStabilizer, .sliderHigh = longestStabilizer, .digits = 3, .step = 1.0, .unit = tr("pixels")});
    m_stabilizer->setObjectName(QStringLiteral("stabilizer"));
    m_stabilizer->describe(tr("Stabilizer"), tr("Steadies the hand: the brush follows the pointer on a string of this length; 0 is off"));
    connect(m_stabilizer, &NumberField::edited, &m_editor, &SphereMapEditor::setStabilizer);
    auto* label = new FieldLabel(tr("Stabilizer"));
    label->setBuddy(m_stabilizer);
    label->setToolTip(m_stabilizer->slider()->toolTip());
    label->setReset([this] { m_stabilizer->reset(); });
    auto* hand = new QFormLayout;
    hand->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    hand->addRow(label, m_stabilizer);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 10, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_brush);
    column->addLayout(hand);
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
    m_stabilizer->setValue(m_editor.stabilizer());
}

} // namespace mirrorball::studio
