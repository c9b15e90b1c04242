#pragma once

#include "widgets/workspace/snapshots.h"

#include <QLabel>
#include <QWidget>

namespace mirrorball::studio {

/// What a compared picture's parts are, in the picture: A and B with their names, and how far B is from A. Labels let the mouse through.
class ComparisonLabels : public QObject {
    Q_OBJECT

public:
    ComparisonLabels(const Snapshots& snapshots, QWidget& picture);
    /// Where the wipe's line stands, as a fraction of the width.
    void setWipe(double fraction);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* add(const char* name);
    void follow();
    void put(QLabel& label, const QString& text, int left, int right);

    const Snapshots& m_snapshots;
    QWidget& m_picture;
    double m_wipe = 0.5;
    QLabel *m_a, *m_b, *m_figures;
};

} // namespace mirrorball::studio
