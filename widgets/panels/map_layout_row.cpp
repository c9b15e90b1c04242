#include "map_layout_row.h"

#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include <algorithm>

namespace mirrorball::studio {

MapLayoutRow::MapLayoutRow(Document& document, QWidget* parent) : QWidget(parent), m_document(document)
{
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
    arrange();

    connect(m_kind, &QComboBox::activated, this, [this, &document] {
        const auto kind = static_cast<Parameterization>(m_kind->currentData().toInt());
        document.edit(tr("Parameterization"), {}, [kind](Scene& scene) {
            scene.map.parameterization = kind;
            if (!mapping(kind).hasBorder)
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
    connect(m_compare, &QComboBox::currentIndexChanged, this, &MapLayoutRow::comparedChanged);
    connect(&document, &Document::changed, this, &MapLayoutRow::readScene);
    readScene();
}

// Two rows, of which neither grows with what is chosen: a dock keeps its size.
void MapLayoutRow::arrange()
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setVerticalSpacing(6);
    layout->addWidget(m_kind, 0, 0);
    layout->addWidget(m_size, 0, 1, 1, 2);
    layout->addWidget(m_compare, 1, 0);
    layout->addWidget(m_borderLabel, 1, 1);
    layout->addWidget(m_border, 1, 2);
    layout->setColumnStretch(0, 1);
    keepPlace(*m_borderLabel);
    keepPlace(*m_border);
}

std::optional<Parameterization> MapLayoutRow::compared() const
{
    const int choice = m_compare->currentData().toInt();
    return choice < 0 ? std::nullopt : std::optional(static_cast<Parameterization>(choice));
}

void MapLayoutRow::readScene()
{
    const MapSettings& map = m_document.scene().map;
    const QSignalBlocker blockers[]{QSignalBlocker(m_kind), QSignalBlocker(m_size), QSignalBlocker(m_border)};
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(map.parameterization)));
    m_size->setValue(map.size);
    m_border->setRange(0, std::max(0, (map.size - 1) / 2));
    m_border->setValue(map.border);
    const bool hasBorder = mapping(map.parameterization).hasBorder;
    m_border->setVisible(hasBorder);
    m_borderLabel->setVisible(hasBorder);
}

} // namespace mirrorball::studio
