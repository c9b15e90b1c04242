#include "picture_badges.h"

#include "widgets/controls/text.h"

#include "core/scene/display_curves.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

constexpr int fromCorner = 8; ///< pixels

/// Text and explanation of a badge; without a text it is not there.
void say(QPushButton& badge, const QString& text, const QString& help)
{
    badge.setText(text);
    if (!text.isEmpty()) {
        badge.setAccessibleName(text);
        badge.setToolTip(help);
    }
    badge.setVisible(!text.isEmpty());
}

} // namespace

PictureBadges::PictureBadges(Workspace& workspace, QWidget& picture) : QWidget(&picture), m_workspace(workspace), m_picture(picture)
{
    setObjectName(QStringLiteral("pictureBadges"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->setSizeConstraint(QLayout::SetFixedSize);
    m_paint = add("paintBadge", tr("Colors of the paint"), [this] {
        m_workspace.document.edit(tr("Change tone curve"), {}, [](Scene& scene) {
            scene.view.tone = displayCurves(scene).object == ToneCurve::None ? ToneChoice::Filmic : ToneChoice::Auto;
        });
    });
    m_level = add("levelBadge", tr("Level that is shown"), [this] { m_workspace.sphereMap.showOnly(std::nullopt); });
    m_kept = add("keptBadge", tr("Files shown as they were"), [this] { m_workspace.live.refresh(); });
    connect(&m_workspace.live, &LiveScene::updated, this, &PictureBadges::follow);
    connect(&m_workspace.sphereMap, &SphereMapEditor::onlyLevelChanged, this, &PictureBadges::follow);
    connect(&m_workspace.document, &Document::changed, this, &PictureBadges::follow);
    m_picture.installEventFilter(this);
    follow();
}

QPushButton* PictureBadges::add(const char* name, const QString& spoken, std::function<void()> act)
{
    auto* badge = new QPushButton;
    badge->setObjectName(QLatin1String(name));
    badge->setAccessibleName(spoken);
    badge->setToolTip(spoken);
    badge->setProperty("role", QStringLiteral("badge"));
    badge->setCursor(Qt::PointingHandCursor);
    badge->setAutoDefault(false);
    badge->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the picture
    layout()->addWidget(badge);
    layout()->setAlignment(badge, Qt::AlignLeft);
    connect(badge, &QPushButton::clicked, this, std::move(act));
    return badge;
}

void PictureBadges::follow()
{
    const Scene& scene = m_workspace.document.scene();
    if (!showsPaint(scene) || !scene.view.display.config.empty())
        say(*m_paint, {}, {});
    else if (displayCurves(scene).object == ToneCurve::None)
        say(*m_paint, tr("Colors as painted"),
            tr("The sphere map is shown in the colors that were painted. Click to see it through the filmic curve, as light."));
    else
        say(*m_paint, tr("Colors through a tone curve"),
            tr("The sphere map is shown as light, through the tone curve: its colors are not those that were painted. Click to see "
               "those."));
    say(*m_level, m_workspace.sphereMap.onlyLevelText(),
        tr("Every lookup reads this level of the sphere map, whatever its size on the screen, and strokes go to it alone. Click, or press "
           "Escape, to show all levels."));
    showKept();
    place();
}

void PictureBadges::showKept()
{
    const auto made = m_workspace.live.made();
    QStringList names;
    if (made)
        for (const std::string& file : made->keptFiles)
            names << QFileInfo(toQString(file)).fileName();
    if (names.isEmpty())
        say(*m_kept, {}, {});
    else
        say(*m_kept, tr("As last read: %1").arg(names.join(QStringLiteral(", "))),
            tr("%1\nThe picture shows what was read before. It follows when the file is there again; click to look now.")
                .arg(toQString(made->problem.empty() ? made->meshProblem : made->problem)));
}

void PictureBadges::place()
{
    layout()->activate();
    move(fromCorner, m_picture.height() - height() - fromCorner);
}

bool PictureBadges::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || !m_workspace.sphereMap.onlyLevel())
        return QWidget::eventFilter(watched, event);
    event->accept(); // before the shortcut that stops work
    if (event->type() == QEvent::KeyPress)
        m_workspace.sphereMap.showOnly(std::nullopt);
    return true;
}

} // namespace mirrorball::studio
