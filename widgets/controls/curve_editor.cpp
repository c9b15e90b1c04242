#include "curve_editor.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace mirrorball::studio {

CurveEditor::CurveEditor(QWidget* parent)
    : QWidget(parent), m_plot(new CurvePlot(this)), m_before(new QDoubleSpinBox(this)), m_after(new QDoubleSpinBox(this)),
      m_reset(new QToolButton(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(m_plot);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    column->addLayout(row);
    const auto addBox = [&](QDoubleSpinBox* box, const QString& label, double high, const QString& name, const QString& help) {
        box->setRange(0.0, high);
        box->setDecimals(3);
        box->setSingleStep(0.01);
        box->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        box->setKeyboardTracking(false);
        box->setFocusPolicy(Qt::StrongFocus);
        box->setAccessibleName(name);
        box->setToolTip(help);
        auto* title = new QLabel(label);
        title->setBuddy(box);
        title->setToolTip(help);
        row->addWidget(title);
        row->addWidget(box, 1);
    };
    addBox(m_before, tr("Before"), curveFieldHigh("x"), tr("Before"),
           tr("The chosen point across: square root of the light that comes in"));
    addBox(m_after, tr("After"), curveFieldHigh("y"), tr("After"),
           tr("The chosen point upwards: square root of the light that goes out; above 1 it is brighter than white"));
    m_reset->setIcon(QIcon(QStringLiteral(":/icons/reset.svg")));
    m_reset->setAutoRaise(true);
    m_reset->setFocusPolicy(Qt::StrongFocus);
    m_reset->setObjectName(QStringLiteral("resetCurve"));
    m_reset->setAccessibleName(tr("Reset the curve"));
    m_reset->setToolTip(tr("Back to the straight line, which changes nothing"));
    row->addWidget(m_reset);

    connect(m_plot, &CurvePlot::edited, this, &CurveEditor::edited);
    connect(m_plot, &CurvePlot::finished, this, &CurveEditor::finished);
    connect(m_plot, &CurvePlot::chosenChanged, this, &CurveEditor::showChosen);
    connect(m_reset, &QToolButton::clicked, m_plot, &CurvePlot::reset);
    const auto connectBox = [this](QDoubleSpinBox* box, double CurvePoint::*member) {
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, member](double value) {
            CurvePoint point = m_plot->points()[static_cast<size_t>(m_plot->chosen())];
            point.*member = value;
            m_plot->moveChosen(point.x, point.y);
            emit finished();
            showChosen(); // as far as it could go
        });
    };
    connectBox(m_before, &CurvePoint::x);
    connectBox(m_after, &CurvePoint::y);
    setFocusProxy(m_plot);
    showChosen();
}

void CurveEditor::setPoints(const std::vector<CurvePoint>& points)
{
    m_plot->setPoints(points);
    showChosen();
}

void CurveEditor::showChosen()
{
    const bool any = !m_plot->points().empty();
    m_before->setEnabled(any);
    m_after->setEnabled(any);
    if (!any)
        return;
    const CurvePoint& point = m_plot->points()[static_cast<size_t>(m_plot->chosen())];
    const QSignalBlocker quietBefore(m_before), quietAfter(m_after);
    m_before->setValue(point.x);
    m_after->setValue(point.y);
}

} // namespace mirrorball::studio
