#pragma once

#include "test_class.h"

namespace mirrorball::test {

class DiscHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void dragsALightLiveInOneUndoStep();
    void liesOnTheHighlightThatThePictureShows();
    void keepsALightBehindInReach();
    void movesTheLightOfAToonLayer();
    void dragsGradientsWindowsAndTurns();
    void dragsTheMaskAsWell();
    void movesByKeysOneStepAPress();
    void addsAndRemovesLightsOnTheDisc();
    void choosesTheSameLightAsTheForm();
    void givesUpADragByEscape();
    void leavesThePaintLayersAlone();
    void leavesPickingPanningAndBrushKeysAsTheyAre();
    void saysTheAnglesOfWhatIsPointedAt();
    void looksWell();
};

} // namespace mirrorball::test
