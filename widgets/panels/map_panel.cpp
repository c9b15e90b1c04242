#include "map_panel.h"

#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include "core/image/mip_pyramid.h"
#include "core/image/reproject.h"
#include "core/report/error_metrics.h"
#include "core/scene/display_curves.h"
#include "core/sphere/map_sheet.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

/// The size at which a kind's image has about as many texels as another map's.
MapLayout equalTexels(Parameterization kind, const MapLayout& other)
{
    const MapLayout unit{kind, 1, 0};
    const double texels = static_cast<double>(other.width()) * other.height() / (static_cast<double>(unit.width()) * unit.height());
    return {kind, std::max(1, static_cast<int>(std::lround(std::sqrt(texels)))), 0};
}

QString layoutText(const MapLayout& layout)
{
    return QStringLiteral("%1 %2 × %3").arg(fieldText(name(layout.kind))).arg(layout.width()).arg(layout.height());
}

QString figure(double value) { return shortNumberText(value); }

} // namespace

struct MapPanel::Comparison {
    std::shared_ptr<const EnvironmentMap> a, b, difference;
    ErrorMetrics error{};
    double range = 1.0;
};

MapPanel::MapPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_compareRunner(this), m_views(new QSplitter(Qt::Vertical, this)),
      m_view(new MapView(workspace.cursor)), m_otherView(new MapView(workspace.cursor)), m_differenceView(new MapView(workspace.cursor)),
      m_scale(new ColorScaleBar), m_differenceScale(new ColorScaleBar), m_tintScale(new ColorScaleBar), m_readout(new QLabel),
      m_facts(new QLabel)
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
    layout->addWidget(makeLayoutRow());
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
    layout->addWidget(makeViewRow());

    connect(&m_workspace.document, &Document::changed, this, &MapPanel::readScene);
    connect(&m_workspace.live, &LiveScene::updated, this, &MapPanel::showMaps);
    connect(&m_workspace.cursor, &DirectionCursor::moved, this, &MapPanel::showReadout);
    connect(&m_workspace.methodError, &MethodError::changed, this, [this] {
        if (m_workspace.methodError.map())
            showStage(Stage::Error);
        showMaps();
    });
    connect(m_view, &MapView::zoomChanged, this, &MapPanel::showFacts);
    connect(&m_compareRunner, &JobRunner::failed, m_otherView, &MapView::showMessage);
    readScene();
    applyOverlays();
    showMaps();
}

QToolButton* MapPanel::makeButton(const QString& icon, const QString& text, const QString& help)
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

QWidget* MapPanel::makeStageRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_stage = new QComboBox;
    m_stage->setObjectName(QStringLiteral("map.stage"));
    m_stage->setAccessibleName(tr("Stage"));
    m_stage->setToolTip(tr("Which map of the scene is shown"));
    for (const auto& [stage, text] : {std::pair{Stage::Probe, tr("Probe")},
                                      {Stage::Specular, tr("Specular: reflection, filtered")},
                                      {Stage::Diffuse, tr("Diffuse: irradiance")},
                                      {Stage::Background, tr("Background")},
                                      {Stage::Error, tr("Error of a method")}})
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

// Two rows, of which neither grows with what is chosen: a dock keeps its size.
QWidget* MapPanel::makeLayoutRow()
{
    auto* rows = new QWidget;
    auto* layout = new QGridLayout(rows);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setVerticalSpacing(6);
    m_kind = new QComboBox;
    m_kind->setObjectName(QStringLiteral("map.parameterization"));
    m_kind->setAccessibleName(tr("Parameterization"));
    m_kind->setToolTip(tr("How directions become texels: of the scene's map, and of what is shown here"));
    m_compare = new QComboBox;
    m_compare->setObjectName(QStringLiteral("map.compare"));
    m_compare->setAccessibleName(tr("Compare with"));
    m_compare->setToolTip(tr("Shows the same map in another parameterization with as many texels, and the difference of both"));
    m_compare->addItem(tr("alone"), -1);
    for (const Parameterization kind : allParameterizations) {
        m_kind->addItem(labelText(name(kind)), static_cast<int>(kind));
        m_compare->addItem(tr("beside %1").arg(fieldText(name(kind))), static_cast<int>(kind));
    }
    m_size = new QSpinBox;
    m_size->setObjectName(QStringLiteral("map.size"));
    m_size->setAccessibleName(tr("Size"));
    m_size->setToolTip(tr("Edge of a face, disc or octahedron, or height of a latlong, in texels"));
    m_size->setRange(1, 16384);
    m_size->setKeyboardTracking(false);
    m_borderLabel = new QLabel(tr("border"));
    m_border = new QSpinBox;
    m_border->setObjectName(QStringLiteral("map.border"));
    m_border->setAccessibleName(tr("Border"));
    m_border->setToolTip(tr("Paraboloid: texels kept free outside each disc"));
    m_border->setKeyboardTracking(false);
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_kind->setMinimumContentsLength(8);
    m_compare->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_compare->setMinimumContentsLength(8);
    layout->addWidget(m_kind, 0, 0);
    layout->addWidget(m_size, 0, 1, 1, 2);
    layout->addWidget(m_compare, 1, 0);
    layout->addWidget(m_borderLabel, 1, 1);
    layout->addWidget(m_border, 1, 2);
    layout->setColumnStretch(0, 1);
    keepPlace(*m_borderLabel);
    keepPlace(*m_border);

    Document& document = m_workspace.document;
    connect(m_kind, &QComboBox::activated, this, [this, &document] {
        const auto kind = static_cast<Parameterization>(m_kind->currentData().toInt());
        document.edit(tr("Parameterization"), {}, [kind](Scene& scene) {
            scene.map.parameterization = kind;
            if (kind != Parameterization::Paraboloid)
                scene.map.border = 0;
        });
    });
    connect(m_size, &QSpinBox::valueChanged, this, [&document](int size) {
        document.edit(tr("Map size"), {}, [size](Scene& scene) {
            scene.map.size = size;
            scene.map.border = std::min(scene.map.border, (size - 1) / 2);
        });
    });
    connect(m_border, &QSpinBox::valueChanged, this,
            [&document](int border) { document.edit(tr("Map border"), {}, [border](Scene& scene) { scene.map.border = border; }); });
    connect(m_compare, &QComboBox::currentIndexChanged, this, &MapPanel::showMaps);
    return rows;
}

QWidget* MapPanel::makeViewRow()
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
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

    connect(m_colors, &QComboBox::currentIndexChanged, this, &MapPanel::applyColors);
    connect(m_exposure, &NumberField::edited, this, &MapPanel::applyColors);
    connect(m_tint, &QComboBox::currentIndexChanged, this, &MapPanel::applyOverlays);
    connect(m_grid, &QToolButton::toggled, this, &MapPanel::applyOverlays);
    connect(m_seams, &QToolButton::toggled, this, &MapPanel::applyOverlays);
    connect(fit, &QToolButton::clicked, this, [this] {
        for (MapView* view : {m_view, m_otherView, m_differenceView})
            view->fit();
    });
    return box;
}

void MapPanel::showStage(Stage stage) { m_stage->setCurrentIndex(m_stage->findData(static_cast<int>(stage))); }

MapPanel::Stage MapPanel::stage() const { return static_cast<Stage>(m_stage->currentData().toInt()); }

/// What the plan says of a map that it leaves out.
QString MapPanel::whyLeftOut(const char* stageName) const
{
    const auto made = m_workspace.live.made();
    if (!made)
        return tr("The maps are being made.");
    for (const mirrorball::Stage& s : made->plan.stages)
        if (s.name == stageName && s.leftOut)
            return tr("This map is left out: %1.").arg(toQString(s.why));
    return tr("This map is not made.");
}

MapPanel::Shown MapPanel::shown() const
{
    const auto one = [](const std::shared_ptr<const EnvironmentMap>& map, const QString& why) {
        return map ? Shown{.levels = {map}} : Shown{.why = why};
    };
    // Each level keeps all of them alive; none is copied.
    const auto all = [](const MapLevels& levels, const QString& why) {
        Shown result{.why = why};
        for (size_t i = 0; levels && i < levels->size(); ++i)
            result.levels.push_back(std::shared_ptr<const EnvironmentMap>(levels, &(*levels)[i]));
        return result;
    };
    if (stage() == Stage::Error)
        return one(m_workspace.methodError.map(),
                   tr("No method is picked. Click a point in the Report panel to see the signed error of its map here."));
    const auto made = m_workspace.live.made();
    if (!made)
        return {.why = tr("The maps are being made.")};
    switch (stage()) {
    case Stage::Probe:
        return one(made->environment, made->plan.needsProbe() ? tr("The probe is too large to hold: it was filtered while it was read.")
                                                              : tr("Nothing in the scene needs the probe, so it was not read."));
    case Stage::Specular:
        return all(made->maps.specular, whyLeftOut("specular map"));
    case Stage::Diffuse:
        return all(made->maps.diffuse, whyLeftOut("irradiance map"));
    default:
        return all(made->maps.background, whyLeftOut("background"));
    }
}

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

void MapPanel::readScene()
{
    const MapSettings& map = m_workspace.document.scene().map;
    const QSignalBlocker blockers[]{QSignalBlocker(m_kind), QSignalBlocker(m_size), QSignalBlocker(m_border)};
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(map.parameterization)));
    m_size->setValue(map.size);
    m_border->setRange(0, std::max(0, (map.size - 1) / 2));
    m_border->setValue(map.border);
    const bool hasBorder = map.parameterization == Parameterization::Paraboloid;
    m_border->setVisible(hasBorder);
    m_borderLabel->setVisible(hasBorder);
    if (m_map && m_view->window().layout.kind != map.parameterization) // at once: the maps themselves follow when they are made
        showMaps();
}

void MapPanel::showMaps()
{
    const Shown now = shown();
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
    const int choice = m_compare->currentData().toInt();
    const bool compares = choice >= 0 && m_map != nullptr && stage() != Stage::Error;
    m_otherView->setVisible(compares);
    m_differenceView->setVisible(compares);
    m_view->setCaption(compares ? layoutText(m_view->window().layout) : QString());
    m_comparisonFacts.clear();
    if (!compares) {
        m_compareRunner.stop();
        return;
    }
    const MapLayout layout = layoutFor(*m_map), other = equalTexels(static_cast<Parameterization>(choice), layout);
    m_compareRunner.start(
        [map = m_map, layout, other](const JobControl& job) {
            Comparison c;
            const auto resampled = [&](const MapLayout& to) {
                return map->layout == to ? map : std::make_shared<const EnvironmentMap>(reproject(*map, {.target = to}, job));
            };
            c.a = resampled(layout);
            c.b = resampled(other);
            c.difference = std::make_shared<const EnvironmentMap>(difference(*c.a, *c.b, job));
            EnvironmentMap looked = *c.a;
            for (size_t i = 0; i < looked.image.texels.size(); ++i)
                looked.image.texels[i] -= c.difference->image.texels[i];
            c.error = errorMetrics(looked, *c.a);
            c.range = signedRange(*c.difference);
            return c;
        },
        [this](Comparison c) {
            m_view->showMap(c.a, c.a->layout);
            m_view->setCaption(layoutText(c.a->layout));
            m_otherView->showMap(c.b, c.b->layout);
            m_otherView->setCaption(layoutText(c.b->layout));
            m_differenceView->showMap(c.difference, c.difference->layout);
            m_differenceView->setCaption(tr("difference"));
            m_differenceRange = c.range;
            m_comparisonFacts = tr("%1 against %2: rel_rms %3, largest %4 × rms")
                                    .arg(fieldText(name(c.b->layout.kind)), fieldText(name(c.a->layout.kind)), figure(c.error.relRms),
                                         figure(c.error.maxAbs));
            applyColors();
            showFacts();
        });
}

void MapPanel::applyColors()
{
    const double ev = m_exposure->value();
    const bool isFalseColor = m_colors->currentData().toInt() == static_cast<int>(MapColors::Luminance);
    if (m_map && isFalseColor && m_rangeOf != m_map) {
        m_range = luminanceRange(*m_map);
        m_rangeOf = m_map;
    }
    if (m_map && stage() == Stage::Error)
        m_differenceRange = signedRange(*m_map);
    MapColoring coloring{.colors = static_cast<MapColors>(m_colors->currentData().toInt()),
                         .exposure = ev,
                         .tone = displayCurves(m_workspace.document.scene()).behind,
                         .low = m_range.low * std::exp2(-ev),
                         .high = m_range.high * std::exp2(-ev)};
    MapColoring signedColoring{.colors = MapColors::Signed, .high = m_differenceRange * std::exp2(-ev)};
    signedColoring.low = 0.5 * signedColoring.high;
    const bool isError = stage() == Stage::Error;
    if (isError)
        coloring = signedColoring;
    m_colors->setEnabled(!isError);
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
    const MapOverlays overlays{.tint = static_cast<MapTint>(m_tint->currentData().toInt()),
                               .grid = m_grid->isChecked(),
                               .seams = m_seams->isChecked(),
                               .lineWidth = devicePixelRatioF()};
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
    for (QToolButton* overlay : {m_grid, m_seams}) {
        QAction* action = menu->addAction(overlay->text(), overlay, &QToolButton::toggle);
        action->setCheckable(true);
        action->setChecked(overlay->isChecked());
    }
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
    if (stage() == Stage::Error)
        text = m_workspace.methodError.description() + QLatin1Char('\n') + text;
    if (!m_comparisonFacts.isEmpty())
        text += QLatin1Char('\n') + m_comparisonFacts;
    m_facts->setText(text);
}

void MapPanel::resizeEvent(QResizeEvent*) { m_views->setOrientation(width() > 900 ? Qt::Horizontal : Qt::Vertical); }

} // namespace mirrorball::studio
