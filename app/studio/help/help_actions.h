#pragma once

#include "help_window.h"
#include "tour.h"

#include <QMainWindow>
#include <QMenu>
#include <QObject>

#include <memory>

namespace mirrorball::studio {

/// The Help menu: the guide at the page of what has the keys (F1) or is clicked next (Shift+F1), the shortcuts, the tour.
class HelpActions : public QObject {
    Q_OBJECT

public:
    HelpActions(QMainWindow& window, Tour& tour);
    ~HelpActions() override;

    void addTo(QMenu& menu);
    /// F1 in a dialog, which keeps the window's own keys away, opens its page.
    void serve(QWidget& dialog, const QString& page);
    /// The window of the guide; null before it was opened.
    HelpWindow* helpWindow() const { return m_help.get(); }
    bool isAsking() const { return m_isAsking; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    HelpWindow& help();
    void showFor(const QWidget* widget);
    void ask();
    void stopAsking();

    QMainWindow& m_window;
    Tour& m_tour;
    std::unique_ptr<HelpWindow> m_help;
    bool m_isAsking = false; ///< the next click asks for help
};

} // namespace mirrorball::studio
