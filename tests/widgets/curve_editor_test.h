#pragma once

#include "test_class.h"

namespace mirrorball::test {

class CurveEditorTest : public QObject {
    Q_OBJECT

private slots:
    void drawsTheCurveThatCoreEvaluates();
    void addsAPointOnTheCurveAndDragsItInOneStep();
    void keepsPointsBetweenTheirNeighbors();
    void removesAPointThatIsPulledAwayAndBringsItBack();
    void followsKeys();
    void takesNumbersBeyondWhite();
    void putsAPointBackOnTheDiagonalByADoubleClick();
    void resetsToTheCurveThatChangesNothing();
    void changesThePictureOneUndoStepADrag();
    void explainsItsControls();
};

} // namespace mirrorball::test
