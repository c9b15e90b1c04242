#pragma once

#include "test_class.h"

namespace mirrorball::test {

class SphereMapPanelTest : public QObject {
    Q_OBJECT

private slots:
    void offersAWayToStartWithoutAMap();
    void drawsAStrokeByMouseAsOneUndoStep();
    void showsTheStrokeWhileItIsDrawnAsTheFileWillHoldIt();
    void takesAPensPressureAndItsEraserEnd();
    void repeatsStrokesBySymmetry();
    void picksColorsFromTheDisc();
    void changesTheBrushByARightDrag();
    void refusesToPaintOnAnotherLayerInWords();
    void givesUpAStrokeByEscape();
    void hidesRenamesReordersAndDeletesLayers();
    void reordersLayersByDropping();
    void editsParametersOneUndoStepADrag();
    void editsGradientStops();
    void showsTheLevels();
    void opensAndSavesFilesAndTellsWhatIsWrong();
    void paintsOnTheModel();
    void theModelShowsAStrokeWhileItIsDrawn();
    void choosesABrushOnTheModelAsOnTheDisc();
    void masksALayerByPaintingOnItsMask();
    void editsListsOfLights();
    void linesUpTheControlsOfAllForms();
    void offersFilesToLayersThatReadThem();
    void followsHandMadeLevelsWhileAStrokeIsDrawn();
    void looksWell();
};

} // namespace mirrorball::test
