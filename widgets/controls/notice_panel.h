#pragma once

#include "notices.h"

#include <QVBoxLayout>
#include <QWidget>

namespace mirrorball::studio {

/// The notices as strips one below the other: words, the remedy as a button, and a button that closes. Blocks nothing; takes no room while
/// all is well.
class NoticePanel : public QWidget {
    Q_OBJECT

public:
    explicit NoticePanel(Notices& notices, QWidget* parent = nullptr);

private:
    void refresh();
    QWidget* makeStrip(const Notices::Notice& notice);

    Notices& m_notices;
    QVBoxLayout* m_column;
};

} // namespace mirrorball::studio
