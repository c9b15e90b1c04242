#pragma once

#include "test_class.h"

namespace mirrorball::test {

class LobeErrorPanelTest : public QObject {
    Q_OBJECT

private slots:
    void drawsALineForEachChoiceOfLookups();
    void saysThatARoundLobeHasNoCurve();
    void measuresAnewWhenTheMaterialChanges();
};

} // namespace mirrorball::test
