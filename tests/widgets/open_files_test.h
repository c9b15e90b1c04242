#pragma once

#include "test_class.h"

namespace mirrorball::test {

class OpenFilesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void theKindOfAFileIsWhatItHolds_data();
    void theKindOfAFileIsWhatItHolds();
    void theKindOfWhatIsNotThereIsItsEnding();
    void oneDialogOpensEveryKind();
    void recentFilesAreOneListOfAllKinds();
    void aRecentFileThatIsGoneIsNamedAndLeavesTheList();
    void dialogsRememberTheirFolders();
    void theCommandLineOpensEveryKind();
    void everyKindCanBeDropped();
};

} // namespace mirrorball::test
