#include "form_labels.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace mirrorball::studio {

void alignLabels(QWidget& root)
{
    QVector<QLabel*> labels;
    int widest = 0;
    for (const QFormLayout* form : root.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            auto* label = item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
            if (!label || !label->isVisibleTo(&root))
                continue;
            labels << label;
            widest = std::max(widest, label->sizeHint().width());
        }
    for (QLabel* label : labels) {
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        label->setMinimumWidth(widest);
    }
}

} // namespace mirrorball::studio
