#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PaintedLevelTest : public QObject {
    Q_OBJECT

private slots:
    void aClickShowsOneLevelOnDiscAndModel();
    void strokesGoToThatLevelAlone();
    void aStrokeOnTheModelIsSeenWhileItIsDrawn();
    void escapeShowsAllLevelsAgain_data();
    void escapeShowsAllLevelsAgain();
    void keysGoFromLevelToLevel();
    void thumbnailsAreAverages();
};

} // namespace mirrorball::test
