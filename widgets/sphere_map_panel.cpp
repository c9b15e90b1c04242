#include "sphere_map_panel.h"

#include "form_labels.h"
#include "painted_export.h"
#include "text.h"

#include "core/error.h"
#include "core/spheremap/presets.h"
#include "core/spheremap/sphere_map_file.h"

#include <QFileDialog>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("sphere-map");
const QString lightsField = QStringLiteral("lights"); // of PhongLightsLayer

QIcon iconOf(const char* name)
{
    return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name)));
}

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
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, &SphereMapPanel::showLayer);
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
    column->setContentsMargins(24, 24, 24, 24);
    column->setSpacing(10);
    auto* text = new QLabel(tr("A sphere map paints the look of the material by hand: one picture of a ball, in layers, shown live on the model."));
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignCenter);
    auto* fresh = new QPushButton(tr("New sphere map"));
    fresh->setObjectName(QStringLiteral("newSphereMap"));
    fresh->setAccessibleName(tr("New sphere map"));
    fresh->setToolTip(tr("Give the material a sphere map of its own, to paint and layer"));
    fresh->setDefault(true);
    connect(fresh, &QPushButton::clicked, this, [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    auto* preset = new QPushButton(tr("Start from a preset"));
    preset->setObjectName(QStringLiteral("presetSphereMap"));
    preset->setAccessibleName(preset->text());
    preset->setToolTip(tr("Copy a built-in sphere map into the material, to change it"));
    auto* presets = new QMenu(preset);
    addPresets(*presets);
    preset->setMenu(presets);
    auto* open = new QPushButton(tr("Open a file..."));
    open->setObjectName(QStringLiteral("openSphereMap"));
    open->setAccessibleName(open->text());
    open->setToolTip(tr("Show a sphere map or recorded strokes from a file"));
    connect(open, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Open a sphere map"), {}, tr("Sphere maps (*.spheremap *.strokes)"));
        if (!path.isEmpty())
            openMap(path);
    });
    column->addStretch(1);
    column->addWidget(text);
    for (QPushButton* choice : {fresh, preset, open})
        column->addWidget(choice, 0, Qt::AlignHCenter);
    for (QPushButton* choice : {fresh, preset, open})
        choice->setMinimumWidth(180);
    column->addStretch(2);
    return page;
}

void SphereMapPanel::addPresets(QMenu& menu)
{
    for (const SphereMapPreset& preset : sphereMapPresets()) {
        QAction* action = menu.addAction(QString::fromStdString(preset.title));
        action->setToolTip(QString::fromStdString(preset.description));
        connect(action, &QAction::triggered, this, [this, &preset] { m_editor.setMap(tr("Choose a sphere map"), preset.document); });
    }
    menu.setToolTipsVisible(true);
}

void SphereMapPanel::openMap(const QString& path)
{
    try {
        m_editor.setMap(tr("Open a sphere map"), loadSphereMap(toPath(path)));
        m_workspace.notices.clear(noticeSubject);
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = noticeSubject, .text = QString::fromUtf8(error.what())});
    }
}

void SphereMapPanel::saveMapAs(const QString& path)
{
    if (!m_editor.map())
        return;
    try {
        saveSphereMap(*m_editor.map(), toPath(path));
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
    column->addWidget(makeTools());
    m_canvas = new SphereMapCanvas(m_editor);
    m_tabs = new QTabWidget;
    m_tabs->setDocumentMode(true);
    m_tabs->setObjectName(QStringLiteral("sphereMapTabs"));
    m_tabs->addTab(makeLayersPage(), tr("Layers"));
    m_tabs->addTab(makeBrushPage(), tr("Brush"));
    m_levels = new LevelsView(m_editor);
    m_tabs->addTab(m_levels, tr("Levels"));
    m_split = new QSplitter(Qt::Vertical);
    m_split->addWidget(m_canvas);
    m_split->addWidget(m_tabs);
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
    if (m_splitIsChosen)
        return;
    const int canvas = std::min(width(), 2 * height() / 5);
    m_split->setSizes({canvas, height() - canvas});
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
    addTool("eyedropper", tr("Pick a colour"), tr("Pick a colour from the map; Alt does it with every tool"), PaintTool::PickColor);
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
    m_color->setAccessibleName(tr("Brush colour"));
    m_color->setToolTip(tr("Colour of the paint"));
    connect(m_color, &ColorButton::edited, this, [this](const glm::dvec3& color) {
        Brush brush = m_editor.brush();
        brush.color = color;
        m_editor.setBrush(brush);
    });
    bar->addWidget(m_color);

    auto* symmetry = button("symmetry", tr("Symmetry"), tr("Repeat strokes around the centre, or mirror them"));
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
    more->setMenu(makeMapMenu());
    bar->addWidget(more);
    return bar;
}

QMenu* SphereMapPanel::makeMapMenu()
{
    auto* menu = new QMenu(this);
    connect(menu->addAction(tr("New sphere map")), &QAction::triggered, this,
            [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    addPresets(*menu->addMenu(tr("Presets")));
    connect(menu->addAction(tr("Open...")), &QAction::triggered, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Open a sphere map"), {}, tr("Sphere maps (*.spheremap *.strokes)"));
        if (!path.isEmpty())
            openMap(path);
    });
    connect(menu->addAction(tr("Save a copy...")), &QAction::triggered, this, [this] {
        QString path = QFileDialog::getSaveFileName(this, tr("Save the sphere map"), {}, tr("Sphere maps (*.spheremap)"));
        if (!path.isEmpty())
            saveMapAs(path.endsWith(QStringLiteral(".spheremap")) ? path : path + QStringLiteral(".spheremap"));
    });
    auto* picture = new PaintedExport(m_workspace, this);
    connect(menu->addAction(tr("Export the picture...")), &QAction::triggered, picture, &PaintedExport::askAndWrite);
    menu->addSeparator();
    connect(menu->addAction(tr("Remove the sphere map")), &QAction::triggered, this, [this] {
        m_workspace.document.edit(tr("Remove the sphere map"), {}, [](Scene& scene) { scene.material.sphereMap.document = {}; });
    });
    return menu;
}

QWidget* SphereMapPanel::makeLayersPage()
{
    m_layers = new LayerList(m_editor);
    auto* add = button("add", tr("Add layer"), tr("Add a layer above the chosen one"));
    add->setObjectName(QStringLiteral("addLayer"));
    add->setPopupMode(QToolButton::InstantPopup);
    auto* kinds = new QMenu(add);
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
            connect(action, &QAction::triggered, this,
                    [this, name = std::string(kind.name)] { m_editor.addLayer({.content = makeContent(name)}); });
        }
    }
    add->setMenu(kinds);
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

    auto* top = new QWidget;
    auto* column = new QVBoxLayout(top);
    column->setContentsMargins(8, 8, 8, 4);
    column->setSpacing(6);
    column->addLayout(blendRow);
    column->addWidget(m_layers, 1);
    column->addLayout(buttons);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(top);
    splitter->addWidget(scrolled(parameters));
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 2);
    splitter->setSizes({235, 235});
    splitter->setChildrenCollapsible(false);
    m_layerControls = {m_blend, m_opacity, duplicate, up, down, remove};
    return splitter;
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
    auto* hint = new QLabel(tr("Right drag changes radius and hardness, [ and ] step the radius, Alt picks a colour on the disc."));
    hint->setWordWrap(true);
    hint->setProperty("role", QStringLiteral("footnote"));
    column->addWidget(hint);
    column->addStretch(1);
    alignLabels(*inside);
    return scrolled(inside);
}

void SphereMapPanel::showMap()
{
    m_pages->setCurrentIndex(m_editor.map() ? 1 : 0);
    showLayer();
}

void SphereMapPanel::showLayer()
{
    const Layer* layer = m_editor.chosenLayer();
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
