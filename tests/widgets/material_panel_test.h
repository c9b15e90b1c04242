#pragma once

#include "test_class.h"

namespace mirrorball::test {

class MaterialPanelTest : public QObject {
    Q_OBJECT

private slots:
    void everyControlIsOneStepThatCanBeUndone();
    void aDisplayConfigurationIsReadInTheBackgroundAndChosenFrom();
    void theExponentIsLogarithmic();
    void aSliderDragIsOneStepAndADoubleClickResets();
    void stepsByKeysWithModifiers();
    void presetsSetTheWholeMaterial();
    void indexPresetsAndMetals();
    void materialFilesRoundTrip();
    void theCurveFollowsTheMaterial();
    void aPictureIsAFileAndNeedsTextureCoordinates();
};

} // namespace mirrorball::test
