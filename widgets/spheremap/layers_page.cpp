#include "layers_page.h"

#include "widgets/controls/form_labels.h"
#include "widgets/controls/icon_button.h"
#include "widgets/controls/scrolled.h"
#include "widgets/controls/text.h"

#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace mirrorball::studio {

namespace {
const QString lightsField = QStringLiteral("lights"); // of PhongLightsLayer
} // namespace

LayersPage::LayersPage(SphereMapEditor& editor, QWidget* parent)
    : QSplitter(Qt::Vertical, parent), m_editor(editor), m_list(new LayerList(editor))
{
    m_top = makeTop();
    m_parameters = scrolled(makeParameters());
    addWidget(m_top);
    addWidget(m_parameters);
    setStretchFactor(0, 1);
    setStretchFactor(1, 2);
    setChildrenCollapsible(false);
    connect(this, &QSplitter::splitterMoved, this, [this] { m_isDivided = true; });
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &LayersPage::showLayer);
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, [this] {
        showLayer();
        m_parameters->verticalScrollBar()->setValue(0);
    });
    showLayer();
}

QWidget* LayersPage::makeTop()
{
    auto* top = new QWidget;
    auto* column = new QVBoxLayout(top);
    column->setContentsMargins(8, 6, 8, 4);
    column->setSpacing(6);
    column->addLayout(makeBlendRow());
    column->addWidget(m_list, 1);
    column->addLayout(makeButtons());
    return top;
}

QLayout* LayersPage::makeBlendRow()
{
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
    m_layerControls << m_blend << m_opacity;
    return blendRow;
}

QLayout* LayersPage::makeButtons()
{
    auto* add = iconButton("add", tr("Add layer"), tr("Add a layer above the chosen one"));
    add->setObjectName(QStringLiteral("addLayer"));
    add->setPopupMode(QToolButton::InstantPopup);
    add->setMenu(makeKindsMenu(*add));
    auto* duplicate = iconButton("duplicate", tr("Duplicate layer"), tr("Copy the chosen layer"));
    connect(duplicate, &QToolButton::clicked, &m_editor, &SphereMapEditor::duplicateChosen);
    auto* up = iconButton("up", tr("Move up"), tr("Move the chosen layer up (Ctrl+Up)"));
    connect(up, &QToolButton::clicked, this, [this] { m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() + 1); });
    auto* down = iconButton("down", tr("Move down"), tr("Move the chosen layer down (Ctrl+Down)"));
    connect(down, &QToolButton::clicked, this, [this] { m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() - 1); });
    auto* remove = iconButton("delete", tr("Delete layer"), tr("Delete the chosen layer (Delete)"));
    connect(remove, &QToolButton::clicked, &m_editor, &SphereMapEditor::removeChosen);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    for (QToolButton* one : {add, duplicate, up, down, remove})
        buttons->addWidget(one);
    buttons->insertStretch(4);
    m_layerControls << duplicate << up << down << remove;
    return buttons;
}

QWidget* LayersPage::makeParameters()
{
    m_note = new QLabel;
    m_note->setWordWrap(true);
    m_form = new ContentForm([this](const QString& label, const QString& key, const std::function<void(LayerContent&)>& change) {
        m_editor.editLayer(label, key, [&](Layer& layer) { change(layer.content); });
    });
    m_form->setObjectName(QStringLiteral("layerForm"));
    connect(m_form, &SettingsForm::finished, &m_editor, &SphereMapEditor::finishEdit);
    connect(m_form, &SettingsForm::itemChosen, this, [this](const QString& list, int item) {
        if (list == lightsField)
            m_editor.chooseLight(item);
    });
    connect(&m_editor, &SphereMapEditor::lightChanged, this, [this] { m_form->chooseItem(lightsField, m_editor.chosenLight()); });
    auto* parameters = new QWidget;
    auto* column = new QVBoxLayout(parameters);
    column->setContentsMargins(8, 6, 8, 8);
    column->addWidget(m_note);
    column->addWidget(m_form);
    m_mask = new MaskEditor(m_editor);
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    line->setEnabled(false);
    column->addWidget(line);
    column->addWidget(m_mask);
    column->addStretch(1);
    return parameters;
}

QMenu* LayersPage::makeKindsMenu(QToolButton& button)
{
    auto* kinds = new QMenu(&button);
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
void LayersPage::addLayer(const LayerKind& kind)
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

void LayersPage::divide()
{
    if (m_isDivided || height() <= 0)
        return;
    const int rows = m_editor.map() ? static_cast<int>(m_editor.map()->layers.size()) : 0;
    const int around = m_top->sizeHint().height() - m_list->sizeHint().height() + 2 * m_list->frameWidth();
    const int wanted = around + std::max(rows, 2) * std::max(m_list->sizeHintForRow(0), 1);
    const int all = height() - handleWidth();
    const int list = std::min(wanted, std::max(all / 2, all - m_parameters->widget()->sizeHint().height()));
    setSizes({list, all - list});
}

void LayersPage::showLayer()
{
    const Layer* layer = m_editor.chosenLayer();
    QMetaObject::invokeMethod(this, &LayersPage::divide, Qt::QueuedConnection); // when the form has its rows
    if (const size_t kind = layer ? layer->content.index() : SIZE_MAX; std::exchange(m_shownKind, kind) != kind)
        m_parameters->verticalScrollBar()->setValue(0);
    for (QWidget* control : m_layerControls)
        control->setEnabled(layer != nullptr);
    if (!layer) {
        m_form->hide();
        m_note->setText(m_editor.map() ? tr("No layers yet: add one with +.") : QString());
        m_note->setVisible(true);
        return;
    }
    m_blend->setCurrentIndex(static_cast<int>(layer->blend));
    m_opacity->setValue(layer->opacity);
    m_form->showContent(layer->content);
    m_form->chooseItem(lightsField, m_editor.chosenLight());
    QString note;
    if (const auto* unknown = std::get_if<UnknownLayer>(&layer->content))
        note = tr("This version does not know layers of the kind \"%1\". It is kept as it is, and left out of the picture.")
                   .arg(QString::fromStdString(unknown->name));
    else if (const auto* paint = std::get_if<PaintLayer>(&layer->content); paint && paint->strokes.empty())
        note = tr("Draw on the disc, or on the model.");
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    alignLabels(*m_form->parentWidget()); // with the mask's
}

} // namespace mirrorball::studio
