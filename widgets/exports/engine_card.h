#pragma once

#include "core/scene/engine_scene_export.h"

#include <QComboBox>
#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

namespace mirrorball::studio {

/// What an export for one engine writes: its files with size and levels, whether it was proven in the engine, what its files cannot hold of
/// the light, what an application must know beside.
class EngineCard : public QWidget {
    Q_OBJECT

public:
    explicit EngineCard(QWidget* parent = nullptr);

    void show(const EngineProfile& profile);
    /// Once the plan is made, or why it cannot be.
    void showEstimate(const EngineEstimate& estimate);
    void showProblem(const QString& message);
    /// The size that is asked for; 0: the engine's own.
    int size() const;

signals:
    void sizeChanged();

private:
    QLabel *m_title, *m_proven, *m_how, *m_notes;
    QTreeWidget* m_files;
    QComboBox* m_size;
    QString m_note; ///< of the profile
};

/// "proven in 0.187.0", or that the engine cannot run in the tests.
QString provenText(const EngineProfile& profile);

} // namespace mirrorball::studio
