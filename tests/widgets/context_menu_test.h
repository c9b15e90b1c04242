#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ContextMenuTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void thePictureHasAMenu();
    void theMenuStaysAwayFromDragsOfTheRightButton();
    void aProbeOfTheListHasAMenu();
    void aLayerHasAMenu();
    void aMapHasAMenu();
    void aSwatchHasAMenu();
};

} // namespace mirrorball::test
