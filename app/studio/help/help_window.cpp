#include "help_window.h"

#include "guide.h"

#include "app/studio/theme.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

QToolButton* button(const char* iconName, const QString& name, const QString& help)
{
    auto* made = new QToolButton;
    made->setIcon(icon(iconName));
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(help);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

/// Pictures that are wider than a page should be are shown smaller.
void fitPictures(QTextBrowser& browser)
{
    constexpr double widest = 600.0;
    for (QTextBlock block = browser.document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            QTextImageFormat format = part.fragment().charFormat().toImageFormat();
            if (!format.isValid())
                continue;
            const QVariant picture = browser.document()->resource(QTextDocument::ImageResource, QUrl(format.name()));
            const QSizeF size =
                picture.canConvert<QPixmap>() ? QSizeF(picture.value<QPixmap>().size()) : QSizeF(picture.value<QImage>().size());
            if (size.width() <= widest)
                continue;
            format.setWidth(widest);
            format.setHeight(widest * size.height() / size.width());
            QTextCursor cursor(browser.document());
            cursor.setPosition(part.fragment().position());
            cursor.setPosition(part.fragment().position() + part.fragment().length(), QTextCursor::KeepAnchor);
            cursor.setCharFormat(format);
            break; // the block's fragments are others now
        }
}

} // namespace

HelpWindow::HelpWindow() : m_text(new QTextBrowser), m_pages(new QListWidget), m_search(new QLineEdit)
{
    setObjectName(QStringLiteral("help"));
    resize(920, 680);
    m_text->setOpenLinks(false);
    m_text->setAccessibleName(tr("Page of the guide"));
    m_text->setToolTip({});
    m_text->setSearchPaths({QStringLiteral(":/docs")});
    m_text->document()->setDocumentMargin(16);
    m_pages->setAccessibleName(tr("Pages of the guide"));
    m_pages->setFrameShape(QFrame::NoFrame);
    for (const GuidePage& page : guidePages()) {
        auto* item = new QListWidgetItem(page.title, m_pages);
        item->setData(Qt::UserRole, page.file);
        item->setToolTip(page.title);
    }
    m_search->setPlaceholderText(tr("Find in this page"));
    m_search->setAccessibleName(tr("Find in this page"));
    m_search->setToolTip(tr("Enter finds the next place (Ctrl+F)"));
    m_search->setClearButtonEnabled(true);
    auto* back = button("undo", tr("Back"), tr("The page before (Alt+Left)"));
    back->setShortcut(QKeySequence::Back);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(6, 6, 6, 0);
    top->addWidget(back);
    top->addStretch(1);
    top->addWidget(m_search);
    auto* split = new QSplitter;
    split->addWidget(m_pages);
    split->addWidget(m_text);
    split->setStretchFactor(1, 1);
    split->setSizes({230, 690});
    split->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(top);
    column->addWidget(split, 1);
    connect(back, &QToolButton::clicked, this, &HelpWindow::goBack);
    connect(m_text, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
    connect(m_search, &QLineEdit::returnPressed, this, &HelpWindow::find);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, this, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
    connect(m_pages, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item && item->data(Qt::UserRole).toString() != m_page)
            showPage(item->data(Qt::UserRole).toString());
    });
}

void HelpWindow::showPage(const QString& page, const QString& words)
{
    const QString file = page.section(u'#', 0, 0);
    if (file != m_page) {
        if (!m_page.isEmpty())
            m_history.push_back({m_page, m_text->verticalScrollBar()->value()});
        load(file);
    }
    scrollTo(page.section(u'#', 1));
    if (!words.isEmpty()) {
        m_search->setText(words);
        find();
    }
    show();
    raise();
    activateWindow();
    m_text->setFocus();
}

void HelpWindow::load(const QString& file)
{
    m_page = file;
    m_text->setMarkdown(guideText(file));
    fitPictures(*m_text);
    for (int i = 0; i < m_pages->count(); ++i)
        if (m_pages->item(i)->data(Qt::UserRole).toString() == file) {
            m_pages->setCurrentRow(i);
            setWindowTitle(tr("%1 - Mirrorball's guide").arg(m_pages->item(i)->text()));
        }
}

void HelpWindow::showHtml(const QString& title, const QString& html)
{
    m_page.clear();
    m_pages->setCurrentRow(-1);
    setWindowTitle(tr("%1 - Mirrorball's guide").arg(title));
    m_text->setHtml(html);
    show();
    raise();
    activateWindow();
}

void HelpWindow::follow(const QUrl& link)
{
    const QString file = link.path().section(u'/', -1);
    if (!link.scheme().isEmpty() && link.scheme() != QStringLiteral("qrc"))
        QDesktopServices::openUrl(link);
    else if (file.isEmpty())
        scrollTo(link.fragment());
    else if (!guideText(file).isEmpty())
        showPage(link.hasFragment() ? file + u'#' + link.fragment() : file);
}

void HelpWindow::scrollTo(const QString& anchor)
{
    QTextCursor to(m_text->document());
    for (QTextBlock block = m_text->document()->begin(); !anchor.isEmpty() && block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && headingAnchor(block.text()) == anchor)
            to.setPosition(block.position());
    m_text->moveCursor(QTextCursor::End); // so that the heading comes to the top
    m_text->setTextCursor(to);
}

void HelpWindow::find()
{
    if (m_text->find(m_search->text()))
        return;
    m_text->moveCursor(QTextCursor::Start); // once around
    m_text->find(m_search->text());
}

void HelpWindow::goBack()
{
    if (m_history.isEmpty())
        return;
    const Place place = m_history.takeLast();
    load(place.page);
    m_text->verticalScrollBar()->setValue(place.scroll);
}

void HelpWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QWidget::keyPressEvent(event);
}

} // namespace mirrorball::studio
