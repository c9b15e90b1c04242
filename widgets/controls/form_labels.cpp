#include "form_labels.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace mirrorball::studio {

namespace {

/// Whether nobody hid a widget, or what it stands in: what was just made shows only when events are next handled.
bool willShow(const QWidget* widget, const QWidget& root)
{
    for (; widget && widget != &root; widget = widget->parentWidget())
        if (widget->isHidden() && widget->testAttribute(Qt::WA_WState_ExplicitShowHide))
            return false;
    return true;
}

} // namespace

void alignLabels(QWidget& root)
{
    QVector<QLabel*> labels;
    int widest = 0;
    for (const QFormLayout* form : root.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            auto* label = item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
            if (!label || !willShow(label, root))
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
