#pragma once

#include "widgets/controls/options_form.h"
#include "widgets/workspace/probe_guesses.h"
#include "widgets/workspace/probe_watcher.h"
#include "widgets/workspace/workspace.h"

#include "core/image/thumbnail.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QWidget>

#include <optional>
#include <vector>

namespace mirrorball::studio {

/// Of the probe that lights the scene: its facts, which are found in the background, and how its file is read. Where the file fits several
/// parameterizations, a picture of each to choose from.
class ProbeDetails : public QWidget {
    Q_OBJECT

public:
    ProbeDetails(Workspace& workspace, const ProbeWatcher& watcher, QWidget* parent = nullptr);

    /// The facts of the probe, or why it has none, in words.
    QString factsText() const { return m_facts->text(); }
    /// The buttons of the parameterizations that the file may have; empty where it is known.
    QList<QToolButton*> guesses() const;
    bool isSurveyed() const { return !m_survey.isBusy(); }

private:
    void makeFacts();
    OptionsForm* makeForm();
    void survey();
    void showSurvey(const ProbeSurvey& survey, const std::vector<ProbeGuess>& guesses);
    void showGuesses(const std::vector<ProbeGuess>& guesses);
    void showProblem(const QString& message);
    void readAs(std::optional<Parameterization> kind, std::optional<Fit> fit = {});
    void readScene();

    Workspace& m_workspace;
    const ProbeWatcher& m_watcher;
    JobRunner m_survey;
    QLabel *m_name, *m_facts, *m_guessText;
    QWidget* m_guesses;
    QComboBox* m_readAs;
    QProgressBar* m_progress;
    std::vector<Parameterization> m_kinds;
    bool m_isCertain = true;
    ProbeReading m_reading{}; ///< what was surveyed, but for its turn
};

} // namespace mirrorball::studio
