#pragma once

#include "widgets/controls/options_form.h"
#include "widgets/workspace/probe_guesses.h"
#include "widgets/workspace/probe_watcher.h"
#include "widgets/workspace/workspace.h"

#include "core/image/thumbnail.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QWidget>

namespace mirrorball::studio {

/// The probes of one group whose names hold a text.
class ProbeFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setGroup(const QString& group);
    void setText(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString m_group, m_text;
};

/// The Probes dock: thumbnails to choose from, facts of the chosen probe, and how it is read.
class ProbesPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProbesPanel(Workspace& workspace, QWidget* parent = nullptr);

    QListView& list() { return *m_list; }
    /// The facts of the chosen probe, or why it has none, in words.
    QString factsText() const { return m_facts->text(); }
    /// The buttons of the parameterizations that the file may have; empty where it is known.
    QList<QToolButton*> guesses() const;
    bool isSurveyed() const { return !m_survey.isBusy(); }

    QSize sizeHint() const override { return {320, 560}; }

private:
    QWidget* makeGroupRow();
    QWidget* makeDetails();
    void listGroups();
    QString removableFile() const;
    void removeFile();
    void choose(const QModelIndex& index);
    void showMenu(const QPoint& position);
    void markChosen();
    void showEmptiness();
    void survey();
    void showSurvey(const ProbeSurvey& survey, const std::vector<ProbeGuess>& guesses);
    void showProblem(const QString& message);
    void readAs(std::optional<Parameterization> kind, std::optional<Fit> fit = {});
    void readScene();

    Workspace& m_workspace;
    ProbeWatcher m_watcher;
    JobRunner m_survey;
    ProbeFilter m_filter;
    QComboBox* m_group;
    QLineEdit* m_find;
    QListView* m_list;
    QLabel* m_empty;
    QLabel *m_name, *m_facts, *m_guessText;
    QWidget* m_guesses;
    QComboBox* m_readAs;
    QProgressBar* m_progress;
    std::vector<Parameterization> m_kinds;
    bool m_isCertain = true;
    ProbeReading m_reading{}; ///< what was surveyed, but for its turn
};

} // namespace mirrorball::studio
