#pragma once

#include "test_class.h"

namespace mirrorball::test {

class InspectorTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void theValuesAreThoseOfTheFiles();
    void besideTheModelTheDirectionIsTheBackgrounds();
    void theLevelIsWhatTheLookupReads();
    void valuesFollowAnEdit();
    void whereASnapshotIsShownItsLightIsTold();
    void clippedPixelsAreMarked();
    void theHistogramCountsThePicture();
    void keysSwitchAndTheNextRunKnows();
};

} // namespace mirrorball::test
