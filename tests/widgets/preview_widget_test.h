#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PreviewWidgetTest : public QObject {
    Q_OBJECT

private slots:
    void aDragIsOneStep_data();
    void aDragIsOneStep();
    void theGestureThatTurnsTheEnvironmentCanBeChosen();
    void theWheelZooms();
    void keysFrameResetAndExpose();
    void comparesWithASnapshot();
    void theModelPointsIntoTheMap();
};

} // namespace mirrorball::test
