#pragma once

class QWidget;

namespace mirrorball::studio {

/// Gives the labels of all forms that are shown below a widget one width, so that their controls begin on one line.
void alignLabels(QWidget& root);

} // namespace mirrorball::studio
