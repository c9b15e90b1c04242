#pragma once

#include "widgets/workspace/preset_library.h"

#include <QLineEdit>
#include <QWidget>

namespace mirrorball::studio {

/// Which sphere map a scene names: a preset or a file, typed or chosen; empty for none.
class SphereMapSourceField : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapSourceField(PresetLibrary& library, QWidget* parent = nullptr);
    ~SphereMapSourceField() override;

    void setSource(const QString& source);
    void describe(const QString& name, const QString& help);
    QLineEdit& text() { return *m_text; }

signals:
    void edited(const QString& source);

private:
    QLineEdit* m_text;
    QString m_source;
};

/// What file dialogs show where a sphere map is asked for that stays in its file.
QString sphereMapFileFilter();

} // namespace mirrorball::studio
