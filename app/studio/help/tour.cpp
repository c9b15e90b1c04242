#include "tour.h"

#include <QHBoxLayout>
#include <QSettings>

namespace mirrorball::studio {

namespace {

const QString seenKey = QStringLiteral("tour/seen");

QPushButton* button(const char* id, const QString& text, const QString& help)
{
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(id));
    made->setAccessibleName(text);
    made->setToolTip(help);
    made->setAutoDefault(false);
    return made;
}

} // namespace

std::vector<Tour::Step> Tour::makeSteps()
{
    return {
        {tr("Choose a light: click a probe at the left, or drop an .hdr or .exr file on the window."), QStringLiteral("probes"),
         QStringLiteral("probes.list"), [](const Scene& before, const Scene& now) { return now.probe.source != before.probe.source; }},
        {tr("Turn the light: hold Shift and drag with the right button in the picture, or drag \"Turn\" in the View dock."),
         QStringLiteral("view"), QStringLiteral("probe.yaw"),
         [](const Scene& before, const Scene& now) { return now.probe.yawDeg != before.probe.yawDeg; }},
        {tr("Choose a material: another preset, or change lobe, exponent or Fresnel."), QStringLiteral("material"),
         QStringLiteral("materialPresets"), [](const Scene& before, const Scene& now) { return now.material != before.material; }},
        {tr("Choose the kind of the map that the engine will read: a dual paraboloid, a cube, an octahedron."), QStringLiteral("map"),
         QStringLiteral("map.parameterization"),
         [](const Scene& before, const Scene& now) { return now.map.parameterization != before.map.parameterization; }},
        {tr("Write the maps: File > Export maps (Ctrl+E), choose an engine or add maps, then Export."), QStringLiteral("export"), {}, {}},
    };
}

Tour::Tour(Workspace& workspace, QWidget* parent)
    : QFrame(parent), m_workspace(workspace), m_steps(makeSteps()), m_number(new QLabel), m_text(new QLabel),
      m_show(button("tour.show", tr("Show me"), tr("Brings the place to the front"))),
      m_skip(button("tour.skip", tr("Skip"), tr("Goes on without doing this step")))
{
    setObjectName(QStringLiteral("tour"));
    setProperty("role", QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_number->setProperty("role", QStringLiteral("footnote"));
    QPushButton* leave = button("tour.end", tr("End the tour"), tr("Help > Tour of the studio begins it again"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, 6, 4);
    row->addWidget(m_number);
    row->addWidget(m_text, 1);
    for (QPushButton* each : {m_show, m_skip, leave})
        row->addWidget(each);
    connect(m_show, &QPushButton::clicked, this, [this] {
        const Step& step = m_steps[static_cast<size_t>(m_step)];
        emit showRequested(step.dock, step.control);
    });
    connect(m_skip, &QPushButton::clicked, this, [this] { go(m_step + 1); });
    connect(leave, &QPushButton::clicked, this, &Tour::end);
    connect(&m_workspace.document, &Document::changed, this, &Tour::look);
    connect(&m_workspace.document, &Document::dragFinished, this, &Tour::look);
    hide();
}

void Tour::start()
{
    QSettings().setValue(seenKey, true);
    go(0);
}

void Tour::greet()
{
    if (!QSettings().value(seenKey, false).toBool())
        start();
}

void Tour::end()
{
    m_step = -1;
    hide();
}

void Tour::noteExport()
{
    m_hasExported = true;
    look();
}

void Tour::go(int step)
{
    if (step >= steps()) {
        end();
        return;
    }
    m_step = step;
    m_before = m_workspace.document.scene();
    m_hasExported = false;
    m_number->setText(tr("Tour, step %1 of %2").arg(step + 1).arg(steps()));
    m_text->setText(m_steps[static_cast<size_t>(step)].text);
    m_text->setAccessibleName(m_text->text());
    show();
}

/// What was done counts when the hand has let go.
void Tour::look()
{
    if (!isRunning() || m_workspace.document.isDragging())
        return;
    const Step& step = m_steps[static_cast<size_t>(m_step)];
    if (step.isDone ? step.isDone(m_before, m_workspace.document.scene()) : m_hasExported)
        go(m_step + 1);
}

} // namespace mirrorball::studio
