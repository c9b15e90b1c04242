#pragma once

#include "test_class.h"

namespace mirrorball::test {

class MapPanelTest : public QObject {
    Q_OBJECT

private slots:
    void showsThePictureThatCoreDraws();
    void choosesTheParameterizationOfTheSceneAsAnUndoStep();
    void showsEveryStageOrSaysWhyThereIsNone();
    void readsLinearValuesAndTheDirectionUnderTheMouse();
    void marksTheDirectionThatIsPointedAtElsewhere();
    void zoomsWhereTheMouseIsAndFits();
    void isDrivenByKeys();
    void showsAFalseColorScaleThatFollowsTheExposure();
    void showsTwoParameterizationsAndTheirDifference();
    void showsTheErrorOfAMethod();
    void namesAllControls();
};

} // namespace mirrorball::test
