#include "drop_target.h"

#include <QApplication>
#include <QDialog>
#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QUrl>

namespace mirrorball::studio {

namespace {

QStringList localPaths(const QMimeData* dropped)
{
    QStringList paths;
    if (dropped && dropped->hasUrls())
        for (const QUrl& url : dropped->urls())
            if (url.isLocalFile())
                paths << url.toLocalFile();
    return paths;
}

} // namespace

DropTarget::DropTarget(QWidget& window, FileOpener& opener) : QObject(&window), m_window(window), m_opener(opener)
{
    window.setAcceptDrops(true);
    qApp->installEventFilter(this); // fields take dropped files for texts, and lists refuse them: the window comes first
}

void DropTarget::addPlace(QWidget& widget, PlaceOf place)
{
    widget.setAcceptDrops(true);
    m_places.push_back({&widget, std::move(place), new DropMark(widget)});
}

/// Floating docks are windows of their own, and still of this one; dialogs take their own drops.
bool DropTarget::isOfWindow(const QWidget& widget) const
{
    for (const QWidget* at = &widget; at && !qobject_cast<const QDialog*>(at); at = at->parentWidget())
        if (at == &m_window)
            return true;
    return false;
}

/// The innermost place at a position of a widget; null: none.
const DropTarget::Place* DropTarget::placeAt(QWidget& widget, const QPoint& position) const
{
    const QWidget* inner = widget.childAt(position);
    for (const QWidget* at = inner ? inner : &widget; at; at = at->parentWidget())
        for (const Place& place : m_places)
            if (place.widget == at)
                return &place;
    return nullptr;
}

/// What holds where no place is.
DropPlace DropTarget::elsewhere() const { return m_places.isEmpty() ? DropPlace::Elsewhere : m_places.front().place(); }

void DropTarget::hover(const QStringList& paths, const Place* hovered)
{
    const Place* lit = hovered || m_places.isEmpty() ? hovered : &m_places.front();
    const std::pair now(paths, lit ? static_cast<const QWidget*>(lit->widget) : nullptr);
    if (m_hovered == now)
        return; // a mouse moves often, and headers of files are read to tell
    m_hovered = now;
    for (const Place& place : m_places) {
        const bool isAround = lit && lit != &place && (place.widget->isAncestorOf(lit->widget) || lit->widget->isAncestorOf(place.widget));
        if (!place.widget->isVisible() || isAround)
            place.mark->hide();
        else
            place.mark->showText(paths.isEmpty() ? tr("Picture") : m_opener.foretell(paths, place.place()),
                                 &place == lit ? DropMark::Light::Bright : DropMark::Light::Dim);
    }
}

void DropTarget::leave()
{
    m_hovered.reset();
    for (const Place& place : m_places)
        place.mark->hide();
}

bool DropTarget::eventFilter(QObject* watched, QEvent* event)
{
    const bool isDrag = event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove || event->type() == QEvent::Drop;
    if (!isDrag && !(m_hovered && event->type() == QEvent::DragLeave))
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || !isOfWindow(*widget))
        return false;
    if (!isDrag) {
        leave();
        return false;
    }
    auto* drop = static_cast<QDropEvent*>(event);
    QStringList paths = localPaths(drop->mimeData());
    const bool isPicture = paths.isEmpty() && m_keep && drop->mimeData() && drop->mimeData()->hasImage();
    if (paths.isEmpty() && !isPicture)
        return false;
    drop->setDropAction(Qt::CopyAction); // the file stays where it is
    drop->accept();
    const Place* place = placeAt(*widget, drop->position().toPoint());
    if (event->type() != QEvent::Drop) {
        hover(paths, place);
        return true;
    }
    leave();
    if (isPicture)
        paths = {m_keep(drop->mimeData()->imageData().value<QImage>())};
    m_opener.open(paths, place ? place->place() : elsewhere());
    return true;
}

} // namespace mirrorball::studio
