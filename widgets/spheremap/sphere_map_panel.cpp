#include "sphere_map_panel.h"

#include "sphere_map_source_field.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/form_labels.h"
#include "widgets/controls/text.h"
#include "widgets/exports/painted_export.h"
#include "widgets/files/recent_files.h"
#include "widgets/files/use_file.h"

#include "core/base/error.h"
#include "core/scene/sphere_map_source.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"

#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("sphere-map");
const QString lightsField = QStringLiteral("lights"); // of PhongLightsLayer

QIcon iconOf(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

QToolButton* button(const char* iconName, const QString& name, const QString& help)
{
    auto* result = new QToolButton;
    result->setIcon(iconOf(iconName));
    result->setAutoRaise(true);
    result->setAccessibleName(name);
    result->setToolTip(help);
    return result;
}

/// What a new sphere map begins with: a ground to see the model by, and a layer to paint on.
SphereMapDocument freshMap()
{
    SphereMapDocument map;
    map.title = "Untitled";
    map.layers = {{.name = "Ground", .content = GradientLayer{}}, {.name = "Paint", .content = PaintLayer{}}};
    return map;
}

const FieldStyles brushStyles{
    {"mode", {.isHidden = true}},
    {"radius", {.sliderLow = 2e-3, .sliderHigh = 1.0, .scale = Scale::Logarithmic}},
    {"spacing", {.sliderLow = 0.02, .sliderHigh = 4.0, .scale = Scale::Logarithmic}},
};

QScrollArea* scrolled(QWidget* inside)
{
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    return scroll;
}

} // namespace

SphereMapPanel::SphereMapPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_editor(workspace.sphereMap), m_pages(new QStackedWidget(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    m_pages->addWidget(makeStart());
    m_pages->addWidget(makeWork());
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &SphereMapPanel::showMap);
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Material) && !m_editor.map())
            showMap();
    });
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, [this] {
        showLayer();
        m_parameters->verticalScrollBar()->setValue(0);
    });
    connect(&m_editor, &SphereMapEditor::brushChanged, this, &SphereMapPanel::showBrush);
    connect(&m_editor, &SphereMapEditor::problemChanged, this,
            [this](const QString& problem) { m_workspace.notices.set({.subject = noticeSubject, .text = problem}); });
    showMap();
    showBrush();
}

// ---- without a map -------------------------------------------------------------------------------------------------------------

QWidget* SphereMapPanel::makeStart()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(12, 12, 12, 10);
    column->setSpacing(8);
    auto* text =
        new QLabel(tr("A sphere map paints the look of the material by hand: one picture of a ball, in layers, shown live on the model."));
    text->setWordWrap(true);
    const auto choice = [this](const char* object, const QString& name, const QString& help, auto act) {
        auto* made = new QPushButton(name);
        made->setObjectName(QLatin1String(object));
        made->setAccessibleName(name);
        made->setToolTip(help);
        connect(made, &QPushButton::clicked, this, act);
        return made;
    };
    QPushButton* fresh = choice("newSphereMap", tr("New sphere map"), tr("Give the material a sphere map of its own, to paint and layer"),
                                [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    fresh->setDefault(true);
    auto* files = new QHBoxLayout;
    files->setSpacing(6);
    files->addWidget(choice("openSphereMap", tr("Open a file..."), tr("Copy a sphere map or recorded strokes from a file into the scene"),
                            [this] { askAndOpen(); }));
    files->addWidget(choice("linkSphereMap", tr("Link a file..."),
                            tr("Show a sphere map, or a picture of one, that stays in its file and follows it"), [this] { askAndLink(); }));
    auto* heading = new QLabel(tr("Start from a preset"));
    heading->setProperty("role", QStringLiteral("heading"));
    auto* gallery = new PresetGallery(m_workspace.presets);
    connect(gallery, &PresetGallery::chosen, this, &SphereMapPanel::choosePreset);
    column->addWidget(text);
    column->addWidget(fresh);
    column->addLayout(files);
    column->addWidget(heading);
    column->addWidget(gallery, 1);
    return page;
}

void SphereMapPanel::askAndOpen()
{
    const QString path =
        askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Open a sphere map"), .filter = filterOf(FileKind::SphereMap)});
    if (!path.isEmpty())
        openMap(path);
}

void SphereMapPanel::askAndLink()
{
    const QString path =
        askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Link a sphere map"), .filter = sphereMapFileFilter()});
    if (!path.isEmpty())
        linkMap(path);
}

void SphereMapPanel::choosePreset(const QString& name)
{
    if (const SphereMapPreset* preset = findSphereMapPreset(name.toStdString()))
        m_editor.setMap(tr("Choose a sphere map"), preset->document);
}

void SphereMapPanel::linkMap(const QString& path) { linkSphereMap(m_workspace, path); }

// What the scene names becomes a part of it; a picture becomes an image layer.
void SphereMapPanel::ownLinkedMap()
{
    const Scene& scene = m_workspace.document.scene();
    const std::string source = scene.material.sphereMap.source;
    if (!isSphereMapFile(source)) {
        choosePreset(toQString(source));
        return;
    }
    const QString path = toQString(resolved(scene, source));
    if (path.endsWith(QStringLiteral(".spheremap"))) {
        openMap(path);
        return;
    }
    SphereMapDocument map;
    map.title = QFileInfo(path).completeBaseName().toStdString();
    map.layers = {{.name = map.title, .content = ImageLayer{.source = path.toStdString(), .inset = 0.0}}};
    m_editor.setMap(tr("Open a sphere map"), map);
}

void SphereMapPanel::removeMap()
{
    m_workspace.document.edit(tr("Remove the sphere map"), {}, [](Scene& scene) {
        scene.material.sphereMap.document = {};
        scene.material.sphereMap.source.clear();
    });
}

void SphereMapPanel::openMap(const QString& path) { useSphereMap(m_workspace, path); }

void SphereMapPanel::saveMapAs(const QString& path)
{
    if (!m_editor.map())
        return;
    try {
        saveSphereMap(*m_editor.map(), toPath(path));
        rememberRecent(path, FileKind::SphereMap);
        m_workspace.notices.clear(noticeSubject);
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = noticeSubject, .text = QString::fromUtf8(error.what())});
    }
}

// ---- with a map ----------------------------------------------------------------------------------------------------------------

QWidget* SphereMapPanel::makeWork()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bar = makeTools();
    column->addWidget(m_bar);
    m_linked = makeLinked();
    column->addWidget(m_linked);
    m_canvas = new SphereMapCanvas(m_editor);
    m_tabs = new QTabWidget;
    m_tabs->setDocumentMode(true);
    m_tabs->setObjectName(QStringLiteral("sphereMapTabs"));
    m_tabs->addTab(makeLayersPage(), tr("Layers"));
    m_tabs->addTab(makeBrushPage(), tr("Brush"));
    m_levels = new LevelsView(m_editor);
    m_tabs->addTab(m_levels, tr("Levels"));
    m_mapForm = new SphereMapForm(m_workspace);
    m_tabs->addTab(scrolled(m_mapForm), tr("Map"));
    for (const auto& [tab, help] : {std::pair{0, tr("What the map is made of")},
                                    {1, tr("What is painted with")},
                                    {2, tr("The mip chain, level by level")},
                                    {3, tr("How the map is looked up, its size, flecks, and what it is called")}})
        m_tabs->setTabToolTip(tab, help);
    auto* below = new QWidget;
    auto* belowColumn = new QVBoxLayout(below);
    belowColumn->setContentsMargins(0, 0, 0, 0);
    belowColumn->setSpacing(4);
    belowColumn->addWidget(new SphereMapUseRow(m_workspace.document));
    belowColumn->addWidget(m_tabs, 1);
    m_split = new QSplitter(Qt::Vertical);
    m_split->addWidget(m_canvas);
    m_split->addWidget(below);
    m_split->setStretchFactor(0, 0);
    m_split->setStretchFactor(1, 1);
    m_split->setChildrenCollapsible(false);
    connect(m_split, &QSplitter::splitterMoved, this, [this] { m_splitIsChosen = true; });
    column->addWidget(m_split, 1);
    return page;
}

/// A disc in a dock is as high as it is wide, where that leaves enough for the layers; until the user divides the dock otherwise.
void SphereMapPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    QMetaObject::invokeMethod(this, &SphereMapPanel::divideLayers, Qt::QueuedConnection); // when what is inside has its new size
    if (m_splitIsChosen)
        return;
    const int canvas = std::min(width(), 36 * height() / 100);
    m_split->setSizes({canvas, height() - canvas});
}

/// The list is as high as its layers, as long as the parameters of the chosen one have room or half of the page; until the user divides it
/// otherwise.
void SphereMapPanel::divideLayers()
{
    if (m_layerSplitIsChosen || m_layerSplit->height() <= 0)
        return;
    const int rows = m_editor.map() ? static_cast<int>(m_editor.map()->layers.size()) : 0;
    const int around = m_layerTop->sizeHint().height() - m_layers->sizeHint().height() + 2 * m_layers->frameWidth();
    const int wanted = around + std::max(rows, 2) * std::max(m_layers->sizeHintForRow(0), 1);
    const int all = m_layerSplit->height() - m_layerSplit->handleWidth();
    const int list = std::min(wanted, std::max(all / 2, all - m_parameters->widget()->sizeHint().height()));
    m_layerSplit->setSizes({list, all - list});
}

/// A map that stays in its file can be used, not changed.
QWidget* SphereMapPanel::makeLinked()
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(10, 10, 10, 4);
    m_linkedText = new QLabel;
    m_linkedText->setWordWrap(true);
    auto* own = new QPushButton(tr("Edit a copy"));
    own->setObjectName(QStringLiteral("ownSphereMap"));
    own->setAccessibleName(own->text());
    own->setToolTip(tr("Copy it into the scene, to paint and layer"));
    connect(own, &QPushButton::clicked, this, &SphereMapPanel::ownLinkedMap);
    auto* remove = new QPushButton(tr("Remove"));
    remove->setObjectName(QStringLiteral("unlinkSphereMap"));
    remove->setAccessibleName(tr("Remove the sphere map"));
    remove->setToolTip(tr("Show the material without a sphere map"));
    connect(remove, &QPushButton::clicked, this, &SphereMapPanel::removeMap);
    auto* row = new QHBoxLayout;
    row->addWidget(own);
    row->addWidget(remove);
    row->addStretch(1);
    column->addWidget(m_linkedText);
    column->addLayout(row);
    return box;
}

QToolBar* SphereMapPanel::makeTools()
{
    auto* bar = new QToolBar;
    bar->setIconSize({20, 20});
    m_tools = new QActionGroup(this);
    const auto addTool = [&](const char* iconName, const QString& name, const QString& help, PaintTool tool) {
        QAction* action = bar->addAction(iconOf(iconName), name);
        action->setToolTip(help);
        action->setCheckable(true);
        action->setData(static_cast<int>(tool));
        m_tools->addAction(action);
        connect(action, &QAction::triggered, this, [this, tool] { m_editor.setTool(tool); });
    };
    addTool("brush", tr("Paint"), tr("Paint. A pen's pressure counts; its eraser end erases"), PaintTool::Paint);
    addTool("eraser", tr("Erase"), tr("Erase what was painted on this layer"), PaintTool::Erase);
    addTool("smudge", tr("Smudge"), tr("Push what was painted on this layer"), PaintTool::Smudge);
    addTool("eyedropper", tr("Pick a color"), tr("Pick a color from the map; Alt does it with every tool"), PaintTool::PickColor);
    bar->addSeparator();
    QAction* onModel = bar->addAction(iconOf("paint-model"), tr("Paint on the model"));
    onModel->setObjectName(QStringLiteral("paintOnModel"));
    onModel->setToolTip(tr("Paint on the model in the preview; Alt and left drag then turns it"));
    onModel->setCheckable(true);
    connect(onModel, &QAction::toggled, &m_editor, &SphereMapEditor::setPaintsOnModel);
    const auto showTool = [this, onModel] {
        onModel->setChecked(m_editor.paintsOnModel());
        for (QAction* action : m_tools->actions())
            action->setChecked(action->data().toInt() == static_cast<int>(m_editor.tool()));
    };
    connect(&m_editor, &SphereMapEditor::toolChanged, this, showTool);
    showTool();

    bar->addSeparator();
    m_color = new ColorButton;
    m_color->setMinimumWidth(44);
    m_color->setAccessibleName(tr("Brush color"));
    m_color->setToolTip(tr("Color of the paint"));
    connect(m_color, &ColorButton::edited, this, [this](const glm::dvec3& color) {
        Brush brush = m_editor.brush();
        brush.color = color;
        m_editor.setBrush(brush);
    });
    bar->addWidget(m_color);

    auto* symmetry = button("symmetry", tr("Symmetry"), tr("Repeat strokes around the center, or mirror them"));
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
    connect(choices->addAction(tr("More...")), &QAction::triggered, this, [this] { m_tabs->setCurrentIndex(1); });
    symmetry->setMenu(choices);
    bar->addWidget(symmetry);

    auto* spacer = new QWidget;
    spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(spacer);
    QAction* fit = bar->addAction(iconOf("frame"), tr("Fit"));
    fit->setToolTip(tr("Show the whole disc (Home)"));
    connect(fit, &QAction::triggered, this, [this] { m_canvas->fit(); });
    auto* more = button("more", tr("Sphere map"), tr("New, presets, open, save, remove"));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setMenu(makeMapMenu(*more));
    bar->addWidget(more);
    return bar;
}

QMenu* SphereMapPanel::makeMapMenu(QToolButton& button)
{
    auto* menu = new QMenu(this);
    connect(menu->addAction(tr("New sphere map")), &QAction::triggered, this,
            [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    connect(menu->addAction(tr("Presets...")), &QAction::triggered, this, [this, &button] {
        connect(openPresetGallery(m_workspace.presets, button), &PresetGallery::chosen, this, &SphereMapPanel::choosePreset);
    });
    connect(menu->addAction(tr("Open...")), &QAction::triggered, this, &SphereMapPanel::askAndOpen);
    connect(menu->addAction(tr("Link a file...")), &QAction::triggered, this, &SphereMapPanel::askAndLink);
    connect(menu->addAction(tr("Save a copy...")), &QAction::triggered, this, [this] {
        const QString path =
            askWhereToSave(
                this, {.purpose = QStringLiteral("save"), .title = tr("Save the sphere map"), .filter = tr("Sphere maps (*.spheremap)")},
                QStringLiteral(".spheremap"))
                .path;
        if (!path.isEmpty())
            saveMapAs(path.endsWith(QStringLiteral(".spheremap")) ? path : path + QStringLiteral(".spheremap"));
    });
    auto* picture = new PaintedExport(m_workspace, this);
    connect(menu->addAction(tr("Export the picture...")), &QAction::triggered, picture, &PaintedExport::askAndWrite);
    menu->addSeparator();
    connect(menu->addAction(tr("Remove the sphere map")), &QAction::triggered, this, &SphereMapPanel::removeMap);
    return menu;
}

QMenu* SphereMapPanel::makeKindsMenu()
{
    auto* kinds = new QMenu(this);
    kinds->setToolTipsVisible(true);
    LayerRole role = LayerRole::Generator;
    for (const LayerRole wanted : {LayerRole::Generator, LayerRole::Adjustment, LayerRole::Warp}) {
        for (const LayerKind& kind : layerKinds()) {
            if (kind.role != wanted)
                continue;
            if (kind.role != role && role == LayerRole::Generator)
                kinds->addSeparator();
            role = kind.role;
            QAction* action = kinds->addAction(fieldText(kind.title));
            action->setToolTip(labelText(kind.help));
            connect(action, &QAction::triggered, this, [this, kind] { addLayer(kind); });
        }
    }
    return kinds;
}

// A picture without a file would be an error: it is asked for first.
void SphereMapPanel::addLayer(const LayerKind& kind)
{
    Layer layer = makeLayer(kind.name);
    if (auto* image = std::get_if<ImageLayer>(&layer.content)) {
        const QString path = askForImage(this);
        if (path.isEmpty())
            return;
        image->source = path.toStdString();
        layer.name = QFileInfo(path).completeBaseName().toStdString();
    }
    m_editor.addLayer(layer);
}

QWidget* SphereMapPanel::makeLayersPage()
{
    m_layers = new LayerList(m_editor);
    auto* add = button("add", tr("Add layer"), tr("Add a layer above the chosen one"));
    add->setObjectName(QStringLiteral("addLayer"));
    add->setPopupMode(QToolButton::InstantPopup);
    add->setMenu(makeKindsMenu());
    auto* duplicate = button("duplicate", tr("Duplicate layer"), tr("Copy the chosen layer"));
    connect(duplicate, &QToolButton::clicked, &m_editor, &SphereMapEditor::duplicateChosen);
    auto* up = button("up", tr("Move up"), tr("Move the chosen layer up (Ctrl+Up)"));
    connect(up, &QToolButton::clicked, this, [this] { m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() + 1); });
    auto* down = button("down", tr("Move down"), tr("Move the chosen layer down (Ctrl+Down)"));
    connect(down, &QToolButton::clicked, this, [this] { m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() - 1); });
    auto* remove = button("delete", tr("Delete layer"), tr("Delete the chosen layer (Delete)"));
    connect(remove, &QToolButton::clicked, &m_editor, &SphereMapEditor::removeChosen);

    m_blend = new QuietCombo;
    m_blend->setObjectName(QStringLiteral("blend"));
    m_blend->setAccessibleName(tr("Blend mode"));
    m_blend->setToolTip(tr("How the layer meets what lies below"));
    for (const std::string_view word : words(BlendMode{}))
        m_blend->addItem(labelText(word).replace(u'-', u' '));
    connect(m_blend, &QComboBox::activated, this, [this](int index) {
        m_editor.editLayer(tr("Change blend mode"), {}, [&](Layer& layer) { layer.blend = static_cast<BlendMode>(index); });
    });
    m_opacity = new NumberField({.initial = 1.0, .digits = 3});
    m_opacity->setObjectName(QStringLiteral("layerOpacity")); // a brush and a fill have an "opacity" too
    m_opacity->describe(tr("Layer opacity"), tr("How much of the layer shows"));
    connect(m_opacity, &NumberField::edited, this, [this](double value) {
        m_editor.editLayer(tr("Change opacity"), QStringLiteral("opacity"), [&](Layer& layer) { layer.opacity = value; });
    });
    connect(m_opacity, &NumberField::finished, &m_editor, &SphereMapEditor::finishEdit);

    auto* blendRow = new QHBoxLayout;
    blendRow->setSpacing(6);
    blendRow->addWidget(m_blend, 2);
    blendRow->addWidget(m_opacity, 3);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    for (QToolButton* one : {add, duplicate, up, down, remove})
        buttons->addWidget(one);
    buttons->insertStretch(4);

    m_layerNote = new QLabel;
    m_layerNote->setWordWrap(true);
    m_layerForm = new ContentForm([this](const QString& label, const QString& key, const std::function<void(LayerContent&)>& change) {
        m_editor.editLayer(label, key, [&](Layer& layer) { change(layer.content); });
    });
    m_layerForm->setObjectName(QStringLiteral("layerForm"));
    connect(m_layerForm, &SettingsForm::finished, &m_editor, &SphereMapEditor::finishEdit);
    connect(m_layerForm, &SettingsForm::itemChosen, this, [this](const QString& list, int item) {
        if (list == lightsField)
            m_editor.chooseLight(item);
    });
    connect(&m_editor, &SphereMapEditor::lightChanged, this, [this] { m_layerForm->chooseItem(lightsField, m_editor.chosenLight()); });
    auto* parameters = new QWidget;
    auto* parameterColumn = new QVBoxLayout(parameters);
    parameterColumn->setContentsMargins(8, 6, 8, 8);
    parameterColumn->addWidget(m_layerNote);
    parameterColumn->addWidget(m_layerForm);
    m_mask = new MaskEditor(m_editor);
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    line->setEnabled(false);
    parameterColumn->addWidget(line);
    parameterColumn->addWidget(m_mask);
    parameterColumn->addStretch(1);

    m_layerTop = new QWidget;
    auto* column = new QVBoxLayout(m_layerTop);
    column->setContentsMargins(8, 6, 8, 4);
    column->setSpacing(6);
    column->addLayout(blendRow);
    column->addWidget(m_layers, 1);
    column->addLayout(buttons);
    m_parameters = scrolled(parameters);
    m_layerSplit = new QSplitter(Qt::Vertical);
    m_layerSplit->addWidget(m_layerTop);
    m_layerSplit->addWidget(m_parameters);
    m_layerSplit->setStretchFactor(0, 1);
    m_layerSplit->setStretchFactor(1, 2);
    m_layerSplit->setChildrenCollapsible(false);
    connect(m_layerSplit, &QSplitter::splitterMoved, this, [this] { m_layerSplitIsChosen = true; });
    m_layerControls = {m_blend, m_opacity, duplicate, up, down, remove};
    return m_layerSplit;
}

QWidget* SphereMapPanel::makeBrushPage()
{
    m_brushForm = new SettingsForm;
    m_brushForm->setObjectName(QStringLiteral("brushForm"));
    m_brushForm->build<Brush>(
        m_editor.brush(),
        [this](const QString&, const QString&, const std::function<void(Brush&)>& change) {
            Brush brush = m_editor.brush();
            change(brush);
            m_editor.setBrush(brush);
        },
        brushStyles);
    m_symmetryForm = new SettingsForm;
    m_symmetryForm->setObjectName(QStringLiteral("symmetryForm"));
    m_symmetryForm->build<Symmetry>(m_editor.symmetry(),
                                    [this](const QString&, const QString&, const std::function<void(Symmetry&)>& change) {
                                        Symmetry symmetry = m_editor.symmetry();
                                        change(symmetry);
                                        m_editor.setSymmetry(symmetry);
                                    });
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(8, 10, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_brushForm);
    auto* heading = new QLabel(tr("Symmetry"));
    heading->setProperty("role", QStringLiteral("heading"));
    column->addWidget(heading);
    column->addWidget(m_symmetryForm);
    auto* hint = new QLabel(tr("Right drag changes radius and hardness, [ and ] step the radius, Alt picks a color on the disc."));
    hint->setWordWrap(true);
    hint->setProperty("role", QStringLiteral("footnote"));
    column->addWidget(hint);
    column->addStretch(1);
    alignLabels(*inside);
    return scrolled(inside);
}

void SphereMapPanel::showMap()
{
    const SphereMapSettings& settings = m_workspace.document.scene().material.sphereMap;
    const bool isOwn = m_editor.map() != nullptr;
    m_pages->setCurrentIndex(settings.isNone() ? 0 : 1);
    m_bar->setVisible(isOwn);
    m_canvas->setVisible(isOwn);
    m_linked->setVisible(!isOwn);
    m_linkedText->setText(isSphereMapFile(settings.source)
                              ? tr("The material shows %1, which stays in its file.").arg(toQString(settings.source))
                              : tr("The material shows the preset %1.").arg(toQString(settings.source)));
    const bool isNewlyOwn = isOwn && !m_tabs->isTabVisible(0);
    for (int tab = 0; tab < m_tabs->count() - 1; ++tab)
        m_tabs->setTabVisible(tab, isOwn);
    if (isNewlyOwn)
        m_tabs->setCurrentIndex(0); // hiding the others has chosen the last
    showLayer();
}

void SphereMapPanel::showLayer()
{
    const Layer* layer = m_editor.chosenLayer();
    QMetaObject::invokeMethod(this, &SphereMapPanel::divideLayers, Qt::QueuedConnection); // when the form has its rows
    if (const size_t kind = layer ? layer->content.index() : SIZE_MAX; std::exchange(m_shownKind, kind) != kind)
        m_parameters->verticalScrollBar()->setValue(0);
    for (QWidget* control : m_layerControls)
        control->setEnabled(layer != nullptr);
    if (!layer) {
        m_layerForm->hide();
        m_layerNote->setText(m_editor.map() ? tr("No layers yet: add one with +.") : QString());
        m_layerNote->setVisible(true);
        return;
    }
    m_blend->setCurrentIndex(static_cast<int>(layer->blend));
    m_opacity->setValue(layer->opacity);
    m_layerForm->showContent(layer->content);
    m_layerForm->chooseItem(lightsField, m_editor.chosenLight());
    QString note;
    if (const auto* unknown = std::get_if<UnknownLayer>(&layer->content))
        note = tr("This version does not know layers of the kind \"%1\". It is kept as it is, and left out of the picture.")
                   .arg(QString::fromStdString(unknown->name));
    else if (const auto* paint = std::get_if<PaintLayer>(&layer->content); paint && paint->strokes.empty())
        note = tr("Draw on the disc, or on the model.");
    m_layerNote->setText(note);
    m_layerNote->setVisible(!note.isEmpty());
    alignLabels(*m_layerForm->parentWidget()); // with the mask's
}

void SphereMapPanel::showBrush()
{
    m_color->setColor(m_editor.brush().color);
    m_brushForm->show(m_editor.brush());
    m_symmetryForm->show(m_editor.symmetry());
}

} // namespace mirrorball::studio
