#include "mask_editor.h"

#include "widgets/controls/text.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

const std::vector<LayerKind>& generators()
{
    static const std::vector<LayerKind> kinds = [] {
        std::vector<LayerKind> found;
        for (const LayerKind& kind : layerKinds())
            if (kind.role == LayerRole::Generator)
                found.push_back(kind);
        return found;
    }();
    return kinds;
}

/// A fresh mask: painted ones count by where there is paint, whatever its color.
Mask maskOf(const LayerKind& kind)
{
    Mask mask{.content = makeContent(kind.name)};
    if (std::holds_alternative<PaintLayer>(mask.content))
        mask.channel = MaskChannel::Opacity;
    return mask;
}

void name(QWidget* widget, const char* object, const QString& title, const QString& help)
{
    widget->setObjectName(QLatin1String(object));
    widget->setAccessibleName(title);
    widget->setToolTip(help);
}

} // namespace

MaskEditor::MaskEditor(SphereMapEditor& editor, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_kinds(new QuietCombo), m_channel(new QuietCombo), m_invert(new QCheckBox(tr("Inverted"))),
      m_paint(new QToolButton), m_details(new QWidget), m_firstLevel(new QSpinBox), m_lastLevel(new QSpinBox)
{
    makeMask();
    makeControls();
    makeLevels();
    layOut();
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &MaskEditor::follow);
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, &MaskEditor::follow);
    connect(&m_editor, &SphereMapEditor::toolChanged, this, &MaskEditor::follow);
    follow();
}

void MaskEditor::makeMask()
{
    name(m_kinds, "maskKind", tr("Mask"), tr("Where the layer shows: everywhere, or where a picture of this kind is bright or there"));
    m_kinds->addItem(tr("None: everywhere"));
    for (const LayerKind& kind : generators())
        m_kinds->addItem(fieldText(kind.title));
    connect(m_kinds, &QComboBox::activated, this, &MaskEditor::chooseKind);

    name(m_channel, "maskChannel", tr("Mask by"), tr("Luminance: where the mask is bright; opacity: where it is there"));
    for (const std::string_view word : words(MaskChannel{}))
        m_channel->addItem(labelText(word));
    connect(m_channel, &QComboBox::activated, this, [this](int index) {
        m_editor.editLayer(tr("Change the mask"), {}, [&](Layer& layer) {
            if (layer.mask)
                layer.mask->channel = static_cast<MaskChannel>(index);
        });
    });
    name(m_invert, "maskInvert", tr("Inverted mask"), tr("Shows the layer where the mask does not"));
    connect(m_invert, &QCheckBox::clicked, this, [this](bool on) {
        m_editor.editLayer(tr("Invert the mask"), {}, [&](Layer& layer) {
            if (layer.mask)
                layer.mask->invert = on;
        });
    });
}

void MaskEditor::makeControls()
{
    name(m_paint, "paintMask", tr("Paint on the mask"), tr("Strokes go to the mask instead of the layer; erasing takes them away"));
    m_paint->setText(tr("Paint on it"));
    m_paint->setIcon(QIcon(QStringLiteral(":/icons/brush.svg")));
    m_paint->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_paint->setCheckable(true);
    connect(m_paint, &QToolButton::clicked, &m_editor, &SphereMapEditor::setPaintsMask);
    m_form = new ContentForm([this](const QString& label, const QString& key, const std::function<void(LayerContent&)>& change) {
        m_editor.editLayer(label, QStringLiteral("mask.") + key, [&](Layer& layer) {
            if (layer.mask)
                change(layer.mask->content);
        });
    });
    m_form->setObjectName(QStringLiteral("maskForm"));
    connect(m_form, &SettingsForm::finished, &m_editor, &SphereMapEditor::finishEdit);
}

void MaskEditor::makeLevels()
{
    const auto levelBox = [&](QSpinBox* box, const char* object, const QString& title, const QString& help, int Layer::*level) {
        name(box, object, title, help);
        box->setRange(0, deepestLevel);
        box->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        box->setFocusPolicy(Qt::StrongFocus);
        connect(box, &QSpinBox::valueChanged, this, [this, level](int value) {
            m_editor.editLayer(tr("Change levels"), {}, [&](Layer& layer) {
                layer.*level = value;
                if (layer.firstLevel > layer.lastLevel) // the other end gives way
                    (level == &Layer::firstLevel ? layer.lastLevel : layer.firstLevel) = value;
            });
        });
    };
    levelBox(m_firstLevel, "firstLevel", tr("Largest level"),
             tr("The largest level of the mip chain that the layer takes part in; 0 is the full size"), &Layer::firstLevel);
    levelBox(m_lastLevel, "lastLevel", tr("Smallest level"), tr("The smallest level of the mip chain that the layer takes part in"),
             &Layer::lastLevel);
}

void MaskEditor::layOut()
{
    auto* options = new QHBoxLayout;
    options->setContentsMargins(0, 0, 0, 0);
    options->addWidget(m_channel, 1);
    options->addWidget(m_invert);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(0, 0, 0, 0);
    details->addLayout(options);
    details->addWidget(m_paint);
    details->addWidget(m_form);
    auto* levels = new QHBoxLayout;
    levels->addWidget(m_firstLevel, 1);
    levels->addWidget(new QLabel(tr("to")));
    levels->addWidget(m_lastLevel, 1);
    auto* rows = new QFormLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    rows->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    rows->addRow(tr("Mask"), m_kinds);
    rows->addRow(m_details);
    rows->addRow(tr("Levels"), levels);
}

void MaskEditor::chooseKind(int index)
{
    QString picture;
    if (index > 0 && generators()[static_cast<size_t>(index - 1)].name == ImageLayer::kind.name) {
        const Layer* layer = m_editor.chosenLayer();
        const bool isImage = layer && layer->mask && std::holds_alternative<ImageLayer>(layer->mask->content);
        if (!isImage && (picture = askForImage(this)).isEmpty()) {
            follow(); // as it was
            return;
        }
    }
    m_editor.editLayer(index == 0 ? tr("Remove the mask") : tr("Change the mask"), {}, [&](Layer& layer) {
        if (index == 0)
            layer.mask.reset();
        else if (const LayerKind& kind = generators()[static_cast<size_t>(index - 1)];
                 !layer.mask || kindOf(layer.mask->content).name != kind.name)
            layer.mask = maskOf(kind);
        if (layer.mask && !picture.isEmpty())
            std::get<ImageLayer>(layer.mask->content).source = picture.toStdString();
    });
    const Layer* layer = m_editor.chosenLayer();
    m_editor.setPaintsMask(layer && layer->mask && std::holds_alternative<PaintLayer>(layer->mask->content));
}

void MaskEditor::follow()
{
    const Layer* layer = m_editor.chosenLayer();
    setVisible(layer != nullptr);
    if (!layer)
        return;
    const QSignalBlocker quietFirst(m_firstLevel), quietLast(m_lastLevel);
    m_firstLevel->setValue(layer->firstLevel);
    m_lastLevel->setValue(layer->lastLevel);
    m_details->setVisible(layer->mask.has_value());
    if (!layer->mask) {
        m_kinds->setCurrentIndex(0);
        return;
    }
    int index = -1; // of a kind that this version does not know
    for (size_t i = 0; i < generators().size(); ++i)
        if (generators()[i].name == kindOf(layer->mask->content).name)
            index = static_cast<int>(i) + 1;
    m_kinds->setCurrentIndex(index);
    m_channel->setCurrentIndex(static_cast<int>(layer->mask->channel));
    m_invert->setChecked(layer->mask->invert);
    m_paint->setVisible(std::holds_alternative<PaintLayer>(layer->mask->content));
    m_paint->setChecked(m_editor.paintTarget() == PaintTarget::Mask);
    m_form->showContent(layer->mask->content);
}

} // namespace mirrorball::studio
