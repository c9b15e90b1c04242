#include "map_panel.h"

#include "map_comparison.h"
#include "widgets/controls/text.h"

#include "core/image/mip_pyramid.h"
#include "core/scene/display_curves.h"
#include "core/sphere/map_sheet.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

QString layoutText(const MapLayout& layout)
{
    return QStringLiteral("%1 %2 × %3").arg(fieldText(name(layout.kind))).arg(layout.width()).arg(layout.height());
}

QString figure(double value) { return shortNumberText(value); }

} // namespace

MapPanel::MapPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_compareRunner(this), m_layoutRow(new MapLayoutRow(workspace.document)),
      m_look(new MapLook), m_views(new QSplitter(Qt::Vertical, this)), m_view(new MapView(workspace.cursor)),
      m_otherView(new MapView(workspace.cursor)), m_differenceView(new MapView(workspace.cursor)), m_scale(new ColorScaleBar),
      m_differenceScale(new ColorScaleBar), m_tintScale(new ColorScaleBar), m_readout(new QLabel), m_facts(new QLabel)
{
    m_view->setObjectName(QStringLiteral("map.view"));
    m_otherView->setObjectName(QStringLiteral("map.other_view"));
    m_differenceView->setObjectName(QStringLiteral("map.difference_view"));
    m_otherView->setAccessibleName(tr("Map to compare with"));
    m_differenceView->setAccessibleName(tr("Difference of both maps"));
    for (MapView* view : {m_view, m_otherView, m_differenceView})
        m_views->addWidget(view);
    m_views->setChildrenCollapsible(false);
    for (MapView* view : {m_view, m_otherView, m_differenceView}) {
        view->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(view, &QWidget::customContextMenuRequested, this, [this, view](const QPoint& at) { showMenu(*view, at); });
    }

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeStageRow());
    layout->addWidget(m_layoutRow);
    layout->addWidget(m_views, 1);
    layout->addWidget(m_scale);
    layout->addWidget(m_differenceScale);
    layout->addWidget(m_tintScale);
    m_readout->setObjectName(QStringLiteral("map.readout"));
    m_readout->setAccessibleName(tr("Texel under the cursor"));
    m_readout->setTextFormat(Qt::PlainText);
    m_readout->setWordWrap(true);
    m_readout->setMinimumHeight(m_readout->fontMetrics().lineSpacing() * 2);
    m_readout->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_facts->setTextFormat(Qt::PlainText);
    m_facts->setWordWrap(true);
    m_facts->setProperty("role", QStringLiteral("footnote"));
    layout->addWidget(m_readout);
    layout->addWidget(m_facts);
    layout->addWidget(m_look);

    connect(&m_workspace.document, &Document::changed, this, &MapPanel::readScene);
    connect(&m_workspace.live, &LiveScene::updated, this, &MapPanel::showMaps);
    connect(&m_workspace.cursor, &DirectionCursor::moved, this, &MapPanel::showReadout);
    connect(&m_workspace.methodError, &MethodError::changed, this, [this] {
        if (m_workspace.methodError.map())
            showStage(MapStage::Error);
        showMaps();
    });
    connect(m_layoutRow, &MapLayoutRow::comparedChanged, this, &MapPanel::showMaps);
    connect(m_look, &MapLook::colorsChanged, this, &MapPanel::applyColors);
    connect(m_look, &MapLook::overlaysChanged, this, &MapPanel::applyOverlays);
    connect(m_look, &MapLook::fitWanted, this, [this] {
        for (MapView* view : {m_view, m_otherView, m_differenceView})
            view->fit();
    });
    connect(m_view, &MapView::zoomChanged, this, &MapPanel::showFacts);
    connect(&m_compareRunner, &JobRunner::failed, m_otherView, &MapView::showMessage);
    readScene();
    applyOverlays();
    showMaps();
}

QWidget* MapPanel::makeStageRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_stage = new QComboBox;
    m_stage->setObjectName(QStringLiteral("map.stage"));
    m_stage->setAccessibleName(tr("Stage"));
    m_stage->setToolTip(tr("Which map of the scene is shown"));
    for (const auto& [stage, text] : {std::pair{MapStage::Probe, tr("Probe")},
                                      {MapStage::Specular, tr("Specular: reflection, filtered")},
                                      {MapStage::Diffuse, tr("Diffuse: irradiance")},
                                      {MapStage::Background, tr("Background")},
                                      {MapStage::Error, tr("Error of a method")}})
        m_stage->addItem(text, static_cast<int>(stage));
    m_stage->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_stage->setMinimumContentsLength(12);
    m_level = new QSpinBox;
    m_level->setObjectName(QStringLiteral("map.level"));
    m_level->setAccessibleName(tr("Level"));
    m_level->setToolTip(tr("Level of the mip chain; 0 is the largest"));
    m_level->setPrefix(tr("level "));
    m_levelOf = new QLabel;
    layout->addWidget(m_stage, 1);
    layout->addWidget(m_level);
    layout->addWidget(m_levelOf);
    connect(m_stage, &QComboBox::currentIndexChanged, this, &MapPanel::showMaps);
    connect(m_level, &QSpinBox::valueChanged, this, &MapPanel::showMaps);
    return row;
}

void MapPanel::showStage(MapStage stage) { m_stage->setCurrentIndex(m_stage->findData(static_cast<int>(stage))); }

MapStage MapPanel::stage() const { return static_cast<MapStage>(m_stage->currentData().toInt()); }

/// A map that already has the chosen parameterization is shown as it is; another one at as many texels.
MapLayout MapPanel::layoutFor(const EnvironmentMap& map) const
{
    const MapSettings& settings = m_workspace.document.scene().map;
    if (map.layout.kind == settings.parameterization)
        return map.layout;
    MapLayout layout = equalTexels(settings.parameterization, map.layout);
    if (settings.border > 0)
        layout.border = std::min(layout.size * settings.border / std::max(1, settings.size), (layout.size - 1) / 2);
    return layout;
}

/// At once: the maps themselves follow when they are made.
void MapPanel::readScene()
{
    if (m_map && m_view->window().layout.kind != m_workspace.document.scene().map.parameterization)
        showMaps();
}

void MapPanel::showMaps()
{
    const StageMaps now = mapsOf(stage(), m_workspace);
    const int levels = static_cast<int>(now.levels.size());
    {
        const QSignalBlocker blocker(m_level);
        m_level->setRange(0, std::max(0, levels - 1));
    }
    m_level->setVisible(levels > 1);
    m_levelOf->setVisible(levels > 1);
    m_levelOf->setText(tr("of %1").arg(std::max(0, levels - 1)));
    if (levels == 0) {
        m_map.reset();
        m_view->showMessage(now.why);
    } else {
        m_map = now.levels[static_cast<size_t>(m_level->value())];
        m_view->showMap(m_map, layoutFor(*m_map));
    }
    showComparison();
    applyColors();
    showReadout();
    showFacts();
}

void MapPanel::showComparison()
{
    const std::optional<Parameterization> beside = m_layoutRow->compared();
    const bool compares = beside && m_map != nullptr && stage() != MapStage::Error;
    m_otherView->setVisible(compares);
    m_differenceView->setVisible(compares);
    m_view->setCaption(compares ? layoutText(m_view->window().layout) : QString());
    m_comparisonFacts.clear();
    if (!compares) {
        m_compareRunner.stop();
        return;
    }
    const MapLayout layout = layoutFor(*m_map), other = equalTexels(*beside, layout);
    m_compareRunner.start([map = m_map, layout, other](const JobControl& job) { return compareLayouts(map, layout, other, job); },
                          [this](const MapComparison& c) {
                              m_view->showMap(c.a, c.a->layout);
                              m_view->setCaption(layoutText(c.a->layout));
                              m_otherView->showMap(c.b, c.b->layout);
                              m_otherView->setCaption(layoutText(c.b->layout));
                              m_differenceView->showMap(c.difference, c.difference->layout);
                              m_differenceView->setCaption(tr("difference"));
                              m_differenceRange = c.range;
                              m_comparisonFacts = tr("%1 against %2: rel_rms %3, largest %4 × rms")
                                                      .arg(fieldText(name(c.b->layout.kind)), fieldText(name(c.a->layout.kind)),
                                                           figure(c.error.relRms), figure(c.error.maxAbs));
                              applyColors();
                              showFacts();
                          });
}

void MapPanel::applyColors()
{
    const double ev = m_look->exposure();
    if (m_map && m_look->colors() == MapColors::Luminance && m_rangeOf != m_map) {
        m_range = luminanceRange(*m_map);
        m_rangeOf = m_map;
    }
    if (m_map && stage() == MapStage::Error)
        m_differenceRange = signedRange(*m_map);
    MapColoring coloring{.colors = m_look->colors(),
                         .exposure = ev,
                         .tone = displayCurves(m_workspace.document.scene()).behind,
                         .low = m_range.low * std::exp2(-ev),
                         .high = m_range.high * std::exp2(-ev)};
    MapColoring signedColoring{.colors = MapColors::Signed, .high = m_differenceRange * std::exp2(-ev)};
    signedColoring.low = 0.5 * signedColoring.high;
    const bool isError = stage() == MapStage::Error;
    if (isError)
        coloring = signedColoring;
    m_look->setColorsEnabled(!isError);
    m_view->setColoring(coloring);
    m_otherView->setColoring(coloring);
    m_differenceView->setColoring(signedColoring);
    m_scale->setVisible(m_map && coloring.colors != MapColors::Display);
    m_scale->showColoring(coloring);
    m_differenceScale->setVisible(m_differenceView->isVisibleTo(this));
    m_differenceScale->showColoring(signedColoring);
}

void MapPanel::applyOverlays()
{
    const MapOverlays overlays = m_look->overlays();
    for (MapView* view : {m_view, m_otherView, m_differenceView})
        view->setOverlays(overlays);
    m_tintScale->setVisible(overlays.tint != MapTint::None);
    m_tintScale->showTint(overlays.tint);
}

/// What can be done with the map of a view.
void MapPanel::showMenu(MapView& view, const QPoint& position)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("mapMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QString readout = m_readout->text(); // of the texel that was clicked
    menu->addAction(tr("Copy the texel's values"), this, [readout] { QGuiApplication::clipboard()->setText(readout); })
        ->setEnabled(m_workspace.cursor.direction().has_value());
    menu->addAction(tr("Copy the view as a picture"), this, [&view] { QGuiApplication::clipboard()->setPixmap(view.grab()); });
    menu->addSeparator();
    menu->addAction(tr("Show the whole map"), &view, &MapView::fit);
    m_look->addOverlays(*menu);
    menu->popup(view.mapToGlobal(position));
}

void MapPanel::showReadout()
{
    const auto& d = m_workspace.cursor.direction();
    if (!d || !m_map) {
        m_readout->setText(m_map ? tr("Point at the map to read a texel.") : QString());
        return;
    }
    const double degrees = 180.0 / pi;
    const glm::vec3 value = m_view->valueAt(*d);
    const MapLayout& layout = m_view->window().layout;
    const glm::dvec2 p = coordinate(layout, *d);
    m_readout->setText(tr("R %1  G %2  B %3   L %4\ntexel %5, %6   direction %7  %8  %9   lon %10  lat %11")
                           .arg(figure(value.r), figure(value.g), figure(value.b), figure(luminance(glm::dvec3(value))))
                           .arg(std::clamp(static_cast<int>(p.x), 0, layout.width() - 1))
                           .arg(std::clamp(static_cast<int>(p.y), 0, layout.height() - 1))
                           .arg(d->x, 0, 'f', 3)
                           .arg(d->y, 0, 'f', 3)
                           .arg(d->z, 0, 'f', 3)
                           .arg(QString::number(std::atan2(d->x, d->z) * degrees, 'f', 1) + QChar(0x00b0),
                                QString::number(std::asin(std::clamp(d->y, -1.0, 1.0)) * degrees, 'f', 1) + QChar(0x00b0)));
}

void MapPanel::showFacts()
{
    if (!m_map) {
        m_facts->clear();
        return;
    }
    const MapLayout& layout = m_view->window().layout;
    QString text = layoutText(layout);
    if (layout != m_map->layout)
        text += tr(" of a %1").arg(layoutText(m_map->layout));
    text += tr(", shown at %1%").arg(QString::number(100.0 * m_view->zoom() / devicePixelRatioF(), 'f', 0));
    if (stage() == MapStage::Error)
        text = m_workspace.methodError.description() + QLatin1Char('\n') + text;
    if (!m_comparisonFacts.isEmpty())
        text += QLatin1Char('\n') + m_comparisonFacts;
    m_facts->setText(text);
}

void MapPanel::resizeEvent(QResizeEvent*) { m_views->setOrientation(width() > 900 ? Qt::Horizontal : Qt::Vertical); }

} // namespace mirrorball::studio
