#include "export_form.h"

#include "export_format.h"
#include "export_words.h"
#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/text.h"

#include "core/image/image_format.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>

namespace mirrorball::studio {

namespace {

/// Sizes step by doubling and halving.
class SizeBox : public QSpinBox {
public:
    using QSpinBox::QSpinBox;
    void stepBy(int steps) override
    {
        int size = value();
        for (int i = 0; i < std::abs(steps); ++i)
            size = steps > 0 ? size * 2 : std::max(1, size / 2);
        setValue(std::min(size, maximum()));
    }
};

} // namespace

ExportForm::ExportForm(QWidget* parent) : QWidget(parent)
{
    setMinimumWidth(300);
    m_rows = new QFormLayout(this);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_rows->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    makeControls();
    addRows();
    connectNames();
    connectLayout();
    connectFiles();
}

ExportForm::~ExportForm() { disconnectChildren(*this); }

void ExportForm::makeControls()
{
    m_name = new QLineEdit;
    m_kind = new QComboBox;
    m_parameterization = new QComboBox;
    m_size = new SizeBox;
    m_border = new QSpinBox;
    m_format = new QComboBox;
    m_faces = new QCheckBox(tr("six files, one a face"));
    m_mips = new QCheckBox(tr("coarser levels"));
    m_levelFiles = new QCheckBox(tr("one file a level"));
    m_levels = new QSpinBox;
    m_file = new QLineEdit;
    m_files = new QLabel;
    m_files->setWordWrap(true);
    m_files->setProperty("role", QStringLiteral("footnote"));
    for (const ExportKind kind : exportKinds)
        m_kind->addItem(kindText(kind), static_cast<int>(kind));
    for (const Parameterization kind : allParameterizations)
        m_parameterization->addItem(labelText(name(kind)), static_cast<int>(kind));
    for (const ExportFormat& format : exportFormats())
        m_format->addItem(format.text);
    m_size->setRange(1, 16384);
    m_size->setSuffix(tr(" texels"));
    m_border->setSuffix(tr(" texels"));
    m_levels->setRange(0, 16);
    m_levels->setSpecialValueText(tr("down to one texel"));
    for (QSpinBox* box : {m_size, m_border, m_levels})
        box->setKeyboardTracking(false);
}

void ExportForm::addRows()
{
    const auto add = [this](const QString& label, QWidget* control, const char* name, const QString& help) {
        control->setObjectName(QLatin1String(name));
        control->setToolTip(help);
        QString plain = label;
        control->setAccessibleName(plain.remove(u'&'));
        auto* text = new QLabel(label);
        text->setBuddy(control);
        m_rows->addRow(text, control);
    };
    add(tr("&Name"), m_name, "export.name", tr("Letters, digits, - and _; names the files and the description beside them"));
    add(tr("&Map"), m_kind, "export.kind", tr("What is written"));
    add(tr("&Parameterization"), m_parameterization, "export.parameterization", tr("How directions become texels"));
    add(tr("&Size"), m_size, "export.size", tr("Edge of a face, disc or octahedron, or height of a latlong; arrows double and halve"));
    add(tr("&Border"), m_border, "export.border",
        tr("Texels between a disc and the edge of the picture; Blender shows a matcap's outline whole with 2 at 512"));
    add(tr("&Format"), m_format, "export.format", tr("File format and what a texel is stored as"));
    add({}, m_faces, "export.faces", tr("Cube: px, nx, py, ny, pz and nz instead of one stack"));
    add({}, m_mips, "export.mips", tr("Mip levels: each the halving of the one before, across seams; a painted map's as it makes them"));
    add({}, m_levelFiles, "export.level-files",
        tr("Numbered files instead of one that holds all levels; %d in the file's name stands for the number"));
    add(tr("&Levels"), m_levels, "export.levels", tr("How many levels of roughness; each is filtered from the probe itself"));
    add(tr("F&ile"), m_file, "export.file", tr("File name; %s in a cube's stands for the six faces, %d for the number of a level"));
    m_faces->setAccessibleName(tr("Six files"));
    m_levelFiles->setAccessibleName(tr("One file a level"));
    m_mips->setAccessibleName(tr("Halved levels"));
    m_rows->addRow(QString(), m_files);
}

void ExportForm::connectNames()
{
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const std::string text = m_name->text().toStdString();
        emit edited(tr("Export name"), [&](ExportTarget& t) { t.name = text; });
    });
    connect(m_kind, &QComboBox::activated, this, [this] {
        emit edited(tr("Export map"), [this](ExportTarget& t) { t = withKind(t, static_cast<ExportKind>(m_kind->currentData().toInt())); });
    });
    connect(m_file, &QLineEdit::editingFinished, this, [this] {
        const std::string file = m_file->text().trimmed().toStdString();
        emit edited(tr("Export file"), [&](ExportTarget& t) { t.file = file == t.name + ".exr" ? std::string() : file; });
    });
}

void ExportForm::connectLayout()
{
    connect(m_parameterization, &QComboBox::activated, this, [this] {
        emit edited(tr("Export parameterization"), [this](ExportTarget& t) {
            t.parameterization = static_cast<Parameterization>(m_parameterization->currentData().toInt());
            if (!mapping(t.parameterization).hasBorder)
                t.border = 0;
            if (t.parameterization != Parameterization::Cube)
                t = withCubeFiles(t, CubeFiles::One);
        });
    });
    connect(m_size, &QSpinBox::valueChanged, this, [this](int size) {
        emit edited(tr("Export size"), [size](ExportTarget& t) {
            t.size = size;
            t.border = std::min(t.border, (size - 1) / 2);
        });
    });
    connect(m_border, &QSpinBox::valueChanged, this,
            [this](int border) { emit edited(tr("Export border"), [border](ExportTarget& t) { t.border = border; }); });
}

void ExportForm::connectFiles()
{
    connect(m_format, &QComboBox::activated, this, [this](int index) {
        emit edited(tr("Export format"), [index](ExportTarget& t) { t = withFormat(t, exportFormats()[static_cast<size_t>(index)]); });
    });
    connect(m_faces, &QCheckBox::clicked, this, [this](bool six) {
        emit edited(tr("Export files"), [six](ExportTarget& t) { t = withCubeFiles(t, six ? CubeFiles::Six : CubeFiles::One); });
    });
    connect(m_mips, &QCheckBox::clicked, this, [this](bool mips) {
        emit edited(tr("Export levels"), [mips](ExportTarget& t) { t = withMips(t, mips ? Mips::All : Mips::None); });
    });
    connect(m_levelFiles, &QCheckBox::clicked, this, [this](bool each) {
        emit edited(tr("Export files"), [each](ExportTarget& t) { t = withLevelFiles(t, each ? LevelFiles::Each : LevelFiles::One); });
    });
    connect(m_levels, &QSpinBox::valueChanged, this,
            [this](int levels) { emit edited(tr("Export levels"), [levels](ExportTarget& t) { t.levels = levels; }); });
}

void ExportForm::offerPainted(bool hasMap)
{
    const int item = m_kind->findData(static_cast<int>(ExportKind::Painted));
    if (auto* model = qobject_cast<QStandardItemModel*>(m_kind->model()))
        model->item(item)->setEnabled(hasMap);
}

void ExportForm::showTarget(const ExportTarget* target)
{
    setEnabled(target != nullptr);
    const ExportTarget shown = target ? *target : ExportTarget{.name = "map"};
    const QSignalBlocker blockers[]{QSignalBlocker(m_size), QSignalBlocker(m_border), QSignalBlocker(m_levels)};
    m_name->setText(target ? QString::fromStdString(shown.name) : QString());
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(shown.kind)));
    m_parameterization->setCurrentIndex(m_parameterization->findData(static_cast<int>(shown.parameterization)));
    m_size->setRange(1, shown.kind == ExportKind::Painted ? largestSphereMap : 16384);
    m_size->setValue(shown.size);
    m_border->setRange(0, std::max(0, (shown.size - 1) / 2));
    m_border->setValue(shown.border);
    for (size_t i = 0; i < exportFormats().size(); ++i)
        m_format->setItemText(static_cast<int>(i), formatText(exportFormats()[i], shown.kind));
    m_format->setCurrentIndex(formatOf(shown));
    m_faces->setChecked(hasFaceFiles(shown));
    m_mips->setChecked(shown.mips);
    m_levelFiles->setChecked(hasLevelFiles(shown));
    m_levels->setValue(shown.levels);
    m_file->setPlaceholderText(QString::fromStdString(shown.name) + QStringLiteral(".exr"));
    m_file->setText(QString::fromStdString(shown.file));
    const bool isPainted = shown.kind == ExportKind::Painted, isChain = shown.kind == ExportKind::Chain;
    m_mips->setEnabled(canHaveMips(shown));
    m_rows->setRowVisible(m_parameterization, !isPainted);
    m_rows->setRowVisible(m_border, isPainted ? !shown.mips : mapping(shown.parameterization).hasBorder);
    m_rows->setRowVisible(m_faces, !isPainted && shown.parameterization == Parameterization::Cube);
    m_rows->setRowVisible(m_mips, !isChain);
    m_rows->setRowVisible(m_levelFiles, (shown.mips || isChain) && (holdsMips(shown.fileName()) || hasLevelFiles(shown)));
    m_rows->setRowVisible(m_levels, isChain);
}

} // namespace mirrorball::studio
