#pragma once

#include "live_scene.h"

#include "core/report/picture_error.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace mirrorball::studio {

/// How a kept picture, A, is compared with the live one, B.
enum class Comparison { Off, Hold, Wipe, SideBySide, Difference };

/// A scene with its maps, kept to be compared with what is shown now, from where the camera is now.
struct Snapshot {
    QString name{};
    std::shared_ptr<const PreparedScene> made{};
    QImage thumbnail{};
    bool operator==(const Snapshot&) const = default;
};

/// The snapshots of a window, which of them is A, how it is compared, and how far B is from it. They live as long as the window, whatever
/// is opened in it; maps that several share are kept once.
class Snapshots : public QObject {
    Q_OBJECT

public:
    static constexpr QSize thumbnailSize{128, 72};

    const std::vector<Snapshot>& all() const { return m_all; }
    /// Which one is A; -1 while there is none.
    int chosen() const { return m_chosen; }
    /// A, or null.
    const Snapshot* compared() const { return m_chosen < 0 ? nullptr : &m_all[static_cast<size_t>(m_chosen)]; }
    Comparison comparison() const { return m_comparison; }
    /// Of display values of B, with A as reference, both as the picture shows them; nothing while that is not measured.
    const std::optional<PictureError>& error() const { return m_error; }

    /// Keeps a scene under a name of its own and makes it A. @param picture  what it looks like, of any size; null: setPicture() follows
    void keep(std::shared_ptr<const PreparedScene> made, const QImage& picture);
    /// Makes the thumbnails of those that keep this scene and have none.
    void setPicture(const std::shared_ptr<const PreparedScene>& made, const QImage& picture);
    /// A name without a letter changes nothing.
    void rename(int index, const QString& name);
    void remove(int index);
    void choose(int index);
    /// Off while there is no snapshot.
    void setComparison(Comparison comparison);
    void setError(const std::optional<PictureError>& error);

signals:
    void listChanged();       ///< which there are, what they are called, which is A
    void comparisonChanged(); ///< A, or how it is compared
    void errorChanged();

private:
    std::vector<Snapshot> m_all{};
    int m_chosen = -1;
    int m_kept = 0; ///< how many there ever were: names are not given twice
    Comparison m_comparison = Comparison::Off;
    std::optional<PictureError> m_error{};
};

/// "rel_rms 0.0123, PSNR 38.2 dB, SSIM 0.981"; "measuring" while there are no figures.
QString errorText(const std::optional<PictureError>& error);

/// The scene that the snapshot's picture shows: as it was kept, but seen as it is now (shownNow()), and with the exports of now.
Scene broughtBack(const Snapshot& snapshot, const Scene& now);

} // namespace mirrorball::studio
