#pragma once

#include "test_class.h"

namespace mirrorball::test {

class SphereMapPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void offersAWayToStartWithoutAMap();
    void drawsAStrokeByMouseAsOneUndoStep();
    void showsTheStrokeWhileItIsDrawnAsTheFileWillHoldIt();
    void takesAPensPressureAndItsEraserEnd();
    void takesAPensTiltWhereTheBrushHeedsIt();
    void steadiesTheHandByAStringAndRemembersItsLength();
    void repeatsStrokesBySymmetry();
    void picksColorsFromTheDisc();
    void changesTheBrushByARightDrag();
    void refusesToPaintOnAnotherLayerInWords();
    void givesUpAStrokeByEscape();
    void showsTheLevels();
    void opensAndSavesFilesAndTellsWhatIsWrong();
    void paintsOnTheModel();
    void steadiesTheHandOnTheModelToo();
    void theModelShowsAStrokeWhileItIsDrawn();
    void choosesABrushOnTheModelAsOnTheDisc();
    void followsHandMadeLevelsWhileAStrokeIsDrawn();
    void looksWell();
};

} // namespace mirrorball::test
