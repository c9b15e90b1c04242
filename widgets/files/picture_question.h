#pragma once

#include "picture_use.h"

#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/probe_guesses.h"
#include "widgets/workspace/workspace.h"

#include <QDialog>
#include <QLabel>
#include <QToolButton>

namespace mirrorball::studio {

/// Asks what a square picture is, by showing what it would be: an environment, read as each kind that its shape fits, or the picture of a
/// ball, for the material or as a layer.
class PictureQuestion : public QDialog {
    Q_OBJECT

public:
    PictureQuestion(Workspace& workspace, const QString& path, QWidget* parent);
    /// The choices, once they have their pictures.
    QList<QToolButton*> cards() const { return findChildren<QToolButton*>(); }

signals:
    void chosen(mirrorball::studio::PictureUse use, const mirrorball::ProbeReading& reading);

private:
    struct Pictures {
        std::vector<ProbeGuess> probes{};
        QImage ball{};
    };
    static Pictures picturesOf(const QString& path, const JobControl& job);
    void showCards(const Pictures& pictures);
    QToolButton* makeCard(const char* id, const QString& text, const QString& help, const QImage& picture, PictureUse use,
                          const ProbeReading& reading);

    QString m_path;
    bool m_hasLayers; ///< the scene has a sphere map of its own
    QLabel* m_wait;
    QWidget* m_probes;
    QWidget* m_balls;
    JobRunner m_runner;
};

} // namespace mirrorball::studio
