#pragma once

#include "test_class.h"

namespace mirrorball::test {

class SphereMapSettingsTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void everyFieldOfASceneFileHasAControl();
    void useOpacityAndColorAreAtHandAndUndoneStepByStep();
    void theRestOfTheMapIsSetInItsTab();
    void aDoubleClickOnALabelResetsTheField();
    void coordinatesAreInterpolatedAtVerticesByAMenuCommand();
    void theWindowIsSeenFromTheRoom();
    void theWindowsLayersAreChosenByNameOrFile();
    void aPresetIsFoundByTypingAndTakenByEnter();
    void presetsHavePicturesOfTheirBalls();
    void aLinkedMapStaysInItsFileUntilItIsCopied();
    void newLayersAreBlendedAsTheirKindIs();
    void anImageLayerIsAddedWithItsFile();
    void looksWell();
};

} // namespace mirrorball::test
