#pragma once

#include "test_class.h"

namespace mirrorball::test {

class TranslationsTest : public QObject {
    Q_OBJECT

private slots:
    void wordsOfCoreAreThereToTranslate();
};

} // namespace mirrorball::test
