#pragma once

#include "test_class.h"

namespace mirrorball::test {

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void showsThePictureThatTheCommandLineDraws();
    void savesThePictureThatTheCommandLineSaves();
    void everyControlHasTooltipNameAndKeys();
    void oneKeyHidesAndShowsAllDocks();
    void everyCommandOfTheViewMenuCanBeUndone();
    void aPanelBehindATabIsHidden();
    void keepsItsLayoutBetweenRuns();
    void thePaletteFindsAndRunsCommands();
    void everyViewCommandCanBeUndone();
    void aMissingProbeIsNamedAndAPlaceholderShown();
    void aMissingMeshIsNamedAndABoxShown();
    void unsavedChangesAreGuarded();
    void remembersRecentFiles();
};

} // namespace mirrorball::test
