#pragma once

#include "engine_card.h"
#include "export_form.h"
#include "export_list.h"
#include "export_place.h"
#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/workspace.h"

#include "core/scene/export.h"
#include "core/scene/export_estimate.h"

#include <QDialog>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include <functional>
#include <vector>

namespace mirrorball::studio {

/// The scene's light for an engine, chosen from a gallery, or maps of its own list: which are written, as what, and where to; what that
/// will take; and the command line that does the same. The list is the scene's: every change there is an undo step of the document.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDialog(Workspace& workspace, QWidget* parent = nullptr);
    ~ExportDialog() override;

    void setFolder(const QString& folder) { m_place->setFolder(folder); }
    QString folder() const { return m_place->folder(); }
    /// The command that writes the same bytes, or why there is none yet.
    QString command() const { return m_place->command(); }
    QString estimateText() const { return m_total->text(); }
    QString statusText() const { return m_status->text(); }
    bool isExporting() const { return m_isExporting; }
    bool isEstimated() const { return !m_estimator.isBusy(); }

    QSize sizeHint() const override { return {1060, 620}; }

    /// The scene's own maps.
    ExportList& list() { return *m_list; }
    /// The engine that is exported for; null where the scene's own list is.
    const EngineProfile* engine() const { return m_engine; }

public slots:
    /// Turns to an engine by its word, or with an empty one to the scene's own list.
    void chooseEngine(const QString& word);
    void startExport();
    void cancelExport();
    void reject() override;

signals:
    /// The user wants the scene saved, so that the command line can read it.
    void saveRequested();
    void exported(const QStringList& files);

private:
    QLayout* makeTop();
    QWidget* makeGallery();
    QLayout* makeBottom();
    void followParts();
    void followJobs();
    void followDocument();
    void offerPainted();
    void change(const QString& label, const std::function<void(ExportTarget&)>& change);
    void showTarget();
    void estimate();
    void estimateEngine();
    void exportEngine();
    void finish(const std::vector<std::filesystem::path>& written);
    bool canExport() const;
    void showEstimates(const std::vector<ExportEstimate>& estimates);
    void showCommand();
    void say(const QString& message, bool isProblem = false);
    void setExporting(bool exporting);

    Workspace& m_workspace;
    JobRunner m_runner;
    JobRunner m_estimator;
    bool m_isExporting = false;
    const EngineProfile* m_engine = nullptr;
    QListWidget* m_gallery;
    QStackedWidget* m_pages; ///< the scene's own list; the engine's card
    EngineCard* m_card;
    ExportList* m_list;
    ExportForm* m_form;
    ExportPlace* m_place;
    QLabel* m_total;
    QProgressBar* m_progress;
    QLabel* m_status;
    QPushButton *m_export, *m_cancel, *m_close, *m_open;
    std::vector<ExportEstimate> m_estimates;
    double m_sharedSeconds = 0.0; ///< of reading the probe, once for all that need it
};

} // namespace mirrorball::studio
