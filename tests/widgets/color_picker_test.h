#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ColorPickerTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void partsMakeTheColorAgain();
    void hexIsReadAndWritten();
    void blackBodiesAreWhereTablesHaveThem();
    void aClickOnASwatchBringsThePicker();
    void theWheelChoosesAndADragIsOneStep();
    void intensityGoesAboveOne();
    void followsUndoAndWhatIsChosen();
    void keepsSwatchesAndRecentOnes();
    void picksFromTheScreen();
};

} // namespace mirrorball::test
