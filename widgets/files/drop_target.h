#pragma once

#include "drop_mark.h"
#include "file_opener.h"

#include <QObject>
#include <QVector>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>

class QDropEvent;

namespace mirrorball::studio {

/// Files and pictures that are dropped anywhere on a window are opened. While something hovers, the places where it can go light up and
/// name what will become of it there.
class DropTarget : public QObject {
    Q_OBJECT

public:
    /// @param window  outlives this; its floating docks are a part of it
    DropTarget(QWidget& window, FileOpener& opener);

    /// A place that takes drops in its own way. One inside another comes first.
    using PlaceOf = std::function<DropPlace()>;
    void addPlace(QWidget& widget, PlaceOf place);
    /// Keeps a picture that comes without a file. @return its path; empty: it cannot be kept
    using KeepPicture = std::function<QString(const QImage&)>;
    void setPictureKeeper(KeepPicture keep) { m_keep = std::move(keep); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Place {
        QWidget* widget;
        PlaceOf place;
        DropMark* mark;
    };
    bool isOfWindow(const QWidget& widget) const;
    const Place* placeAt(QWidget& widget, const QPoint& position) const;
    DropPlace elsewhere() const;
    void hover(const QStringList& paths, const Place* place);
    void leave();

    QWidget& m_window;
    FileOpener& m_opener;
    KeepPicture m_keep{};
    QVector<Place> m_places;                                           ///< inner ones are found first, by who holds whom
    std::optional<std::pair<QStringList, const QWidget*>> m_hovered{}; ///< what hovers, and over which place
};

} // namespace mirrorball::studio
