#include "map_look.h"

#include <QAction>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

/// A flat button with an icon, by which tests know it, too.
QToolButton* makeButton(const QString& icon, const QString& text, const QString& help)
{
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("map.") + icon);
    button->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(icon)));
    button->setText(text);
    button->setIconSize({18, 18});
    button->setAccessibleName(text);
    button->setToolTip(help);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

MapLook::MapLook(QWidget* parent) : QWidget(parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    m_colors = new QComboBox;
    m_colors->setObjectName(QStringLiteral("map.colors"));
    m_colors->setAccessibleName(tr("Colors"));
    m_colors->setToolTip(tr("As a display shows it, or luminance in false colors"));
    m_colors->addItem(tr("Display"), static_cast<int>(MapColors::Display));
    m_colors->addItem(tr("False color"), static_cast<int>(MapColors::Luminance));
    m_tint = new QComboBox;
    m_tint->setObjectName(QStringLiteral("map.tint"));
    m_tint->setAccessibleName(tr("Overlay"));
    m_tint->setToolTip(tr("What the parameterization does to texels, laid over the map"));
    m_tint->addItem(tr("No overlay"), static_cast<int>(MapTint::None));
    m_tint->addItem(tr("Solid angle"), static_cast<int>(MapTint::SolidAngle));
    m_tint->addItem(tr("Anisotropy"), static_cast<int>(MapTint::Anisotropy));
    m_grid = makeButton(QStringLiteral("grid"), tr("Grid"), tr("Directions: latitudes and longitudes every 15 degrees, and the axes"));
    m_grid->setCheckable(true);
    m_seams = makeButton(QStringLiteral("seams"), tr("Seams"), tr("Where faces, halves and edges of the map meet"));
    m_seams->setCheckable(true);
    auto* fit = makeButton(QStringLiteral("frame"), tr("Fit"), tr("Shows the whole map (0 in the map)"));

    auto* first = new QHBoxLayout;
    first->addWidget(m_colors, 1);
    first->addWidget(m_tint, 1);
    first->addWidget(m_grid);
    first->addWidget(m_seams);
    first->addWidget(fit);
    for (QComboBox* list : {m_colors, m_tint}) {
        list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        list->setMinimumContentsLength(5);
    }
    m_exposure =
        new NumberField({.low = -64, .high = 64, .sliderLow = -10, .sliderHigh = 10, .initial = 0.0, .step = 0.25, .unit = tr("EV")});
    m_exposure->setObjectName(QStringLiteral("map.exposure"));
    m_exposure->describe(tr("Map exposure"), tr("Brightness of the map here; in false colors it moves the scale"));
    layout->addLayout(first);
    auto* exposure = new QHBoxLayout;
    exposure->addWidget(new QLabel(tr("Exposure"))); // of the map, as its control's own name says
    exposure->addWidget(m_exposure, 1);
    layout->addLayout(exposure);

    connect(m_colors, &QComboBox::currentIndexChanged, this, &MapLook::colorsChanged);
    connect(m_exposure, &NumberField::edited, this, &MapLook::colorsChanged);
    connect(m_tint, &QComboBox::currentIndexChanged, this, &MapLook::overlaysChanged);
    connect(m_grid, &QToolButton::toggled, this, &MapLook::overlaysChanged);
    connect(m_seams, &QToolButton::toggled, this, &MapLook::overlaysChanged);
    connect(fit, &QToolButton::clicked, this, &MapLook::fitWanted);
}

MapColors MapLook::colors() const { return static_cast<MapColors>(m_colors->currentData().toInt()); }

MapOverlays MapLook::overlays() const
{
    return {.tint = static_cast<MapTint>(m_tint->currentData().toInt()),
            .grid = m_grid->isChecked(),
            .seams = m_seams->isChecked(),
            .lineWidth = devicePixelRatioF()};
}

void MapLook::addOverlays(QMenu& menu) const
{
    for (QToolButton* overlay : {m_grid, m_seams}) {
        QAction* action = menu.addAction(overlay->text(), overlay, &QToolButton::toggle);
        action->setCheckable(true);
        action->setChecked(overlay->isChecked());
    }
}

} // namespace mirrorball::studio
