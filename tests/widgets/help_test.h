#pragma once

#include "test_class.h"

namespace mirrorball::test {

class HelpTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void theWholeGuideIsThere();
    void everyDockOpensAPageByF1();
    void aDialogOpensItsPageByF1();
    void whatIsThisOpensThePageOfWhatIsClicked();
    void linksAndHistoryLead();
    void theShortcutsAreThoseOfTheActions();
    void theTourDoesARealJob();
    void theTourIsOfferedOnce();
    void aStepCanBeShownOrSkipped();
    void samplesOpenWithoutAFile();
    void thePaletteFindsControls();
};

} // namespace mirrorball::test
