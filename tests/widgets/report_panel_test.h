#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ReportPanelTest : public QObject {
    Q_OBJECT

private slots:
    void measuresEveryMethodOfTheMaterial();
    void aClickOnAPointChoosesTheMethod();
    void keysChooseInTheTable();
    void measuresAgainWhenTheLobeChangesAndOnlyThen();
    void givesWayToADragAndGoesOnAfterIt();
    void saysThatAMirrorIsNotFiltered();
    void stopsWhenAsked();
    void namesAllControls();
};

} // namespace mirrorball::test
