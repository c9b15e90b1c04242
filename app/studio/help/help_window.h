#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QWidget>

namespace mirrorball::studio {

/// The guide in a window of its own: its pages at the left, one of them at the right, links, history and a search in the page. It stays
/// usable beside a dialog.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    HelpWindow();

    /// Shows a page, "reports.md" or with a heading "studio.md#colors". @param words  to be found and marked in it; empty: none
    void showPage(const QString& page, const QString& words = {});
    /// Shows a page that is made here, as HTML.
    void showHtml(const QString& title, const QString& html);
    /// The file that is shown; empty for one that is made here.
    const QString& page() const { return m_page; }
    QTextBrowser& text() { return *m_text; }
    QListWidget& pages() { return *m_pages; }
    QLineEdit& search() { return *m_search; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Place {
        QString page{};
        int scroll = 0;
    };
    void load(const QString& file);
    void follow(const QUrl& link);
    void scrollTo(const QString& anchor);
    void find();
    void goBack();

    QTextBrowser* m_text;
    QListWidget* m_pages;
    QLineEdit* m_search;
    QString m_page{};
    QVector<Place> m_history{};
};

} // namespace mirrorball::studio
