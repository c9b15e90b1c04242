#pragma once

#include "widgets/workspace/workspace.h"

#include <QPushButton>
#include <QWidget>

#include <functional>

namespace mirrorball::studio {

/// What a picture does not say by itself, in words in its lower left corner: that colors are shown as they were painted, that one level of
/// a sphere map is shown alone, that a file is gone and the picture shows what it held before. A click on a badge switches what it names,
/// or looks for the file again; Escape shows all levels again.
///
/// Lies on the picture's widget, as large as its badges and no larger, so that everything beside them stays the picture's.
class PictureBadges : public QWidget {
    Q_OBJECT

public:
    PictureBadges(Workspace& workspace, QWidget& picture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPushButton* add(const char* name, const QString& spoken, std::function<void()> act);
    void follow();
    void showKept();
    void place();

    Workspace& m_workspace;
    QWidget& m_picture;
    QPushButton* m_paint;
    QPushButton* m_level;
    QPushButton* m_kept;
};

} // namespace mirrorball::studio
