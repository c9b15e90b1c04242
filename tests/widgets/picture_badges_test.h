#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PictureBadgesTest : public QObject {
    Q_OBJECT

private slots:
    void paintIsShownInItsOwnColorsAndAClickSwitchesTheCurve();
    void aProbeThatVanishesStaysInThePictureUnderItsName();
};

} // namespace mirrorball::test
