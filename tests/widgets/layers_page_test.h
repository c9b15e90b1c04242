#pragma once

#include "test_class.h"

namespace mirrorball::test {

class LayersPageTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void hidesRenamesReordersAndDeletesLayers();
    void reordersLayersByDropping();
    void editsParametersOneUndoStepADrag();
    void editsGradientStops();
    void masksALayerByPaintingOnItsMask();
    void editsListsOfLights();
    void linesUpTheControlsOfAllForms();
    void offersFilesToLayersThatReadThem();
    void parametersWithoutEffectAreHidden();
    void namesThatThereAreAreOffered();
    void anotherLayersParametersBeginAtTheirTop();
    void theListShowsTheLayersThatThereAre();
};

} // namespace mirrorball::test
