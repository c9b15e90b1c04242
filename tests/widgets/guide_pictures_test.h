#pragma once

#include "test_class.h"

namespace mirrorball::test {

/// Draws the guide's pictures of the studio, docs/studio*.png: tools/studio_pictures.
class GuidePicturesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void studio();
    void map();
    void exports();
    void sphereMap();
    void comparison();
};

} // namespace mirrorball::test
