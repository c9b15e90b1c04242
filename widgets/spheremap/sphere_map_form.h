#pragma once

#include "widgets/controls/options_form.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>
#include <QWidget>

namespace mirrorball::studio {

/// What an artist reaches for most of how a sphere map meets the material: use, opacity and, where the map lies over a color, that; in one
/// row.
class SphereMapUseRow : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapUseRow(Document& document, QWidget* parent = nullptr);

private:
    void follow();

    Document& m_document;
    QComboBox* m_use;
    NumberField* m_opacity;
    ColorButton* m_color;
};

/// The rest of it: where a linked map comes from, how the map is looked up, at which size and levels, flecks, and what the map is called.
class SphereMapForm : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapForm(Workspace& workspace, QWidget* parent = nullptr);
    OptionsForm& form() { return *m_form; }

private:
    void addSource();
    void addIndex();
    void addWords();

    Workspace& m_workspace;
    OptionsForm* m_form;
};

} // namespace mirrorball::studio
