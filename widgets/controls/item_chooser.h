#pragma once

#include <QTabBar>
#include <QToolButton>
#include <QWidget>

namespace mirrorball::studio {

/// Which of a list of like things is shown: lights, bands, points of a curve; with buttons that add and remove one.
class ItemChooser : public QWidget {
    Q_OBJECT

public:
    /// @param least, most  how many there may be
    ItemChooser(int least, int most, QWidget* parent = nullptr);

    int count() const { return m_numbers->count(); }
    void setCount(int count);
    /// -1 without items.
    int chosen() const { return m_numbers->currentIndex(); }
    void choose(int index) { m_numbers->setCurrentIndex(index); }
    /// Names the controls for tooltips and screen readers. @param items  "lights"
    void describe(const QString& items, const QString& help);
    QToolButton& addButton() { return *m_add; }
    QToolButton& removeButton() { return *m_remove; }

signals:
    void chosenChanged();
    void addRequested();
    void removeRequested();

private:
    int m_least, m_most;
    QTabBar* m_numbers;
    QToolButton* m_add;
    QToolButton* m_remove;
};

} // namespace mirrorball::studio
