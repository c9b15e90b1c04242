#include "picture_question.h"

#include "widgets/controls/text.h"
#include "widgets/picture/screen_picture.h"

#include "core/base/error.h"
#include "core/scene/sphere_map_source.h"
#include "core/spheremap/evaluation/contact_sheet.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr int ballEdge = 96;
constexpr QSize environmentSize(128, 64);

/// The disc of a picture, as it would look on a ball.
QImage ballOf(const QString& path, const JobControl& job)
{
    Scene scene;
    scene.material.sphereMap.source = path.toStdString();
    const SphereMapTexels texels =
        readSphereMap(scene, "material.sphere_map.source", scene.material.sphereMap.source, 2 * ballEdge, SphereMapLevels::Plain, job);
    // The level that is just larger than the card.
    const std::vector<Image>& levels = texels.levels;
    const auto small = std::find_if(levels.rbegin(), levels.rend(), [](const Image& level) { return level.width >= ballEdge; });
    return onScreen(cutToDisc(small == levels.rend() ? levels.front() : *small), job)
        .scaled(ballEdge, ballEdge, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

QLabel* heading(const QString& text)
{
    auto* label = new QLabel(text);
    label->setProperty("role", QStringLiteral("heading"));
    return label;
}

QWidget* row()
{
    auto* made = new QWidget;
    auto* layout = new QHBoxLayout(made);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setAlignment(Qt::AlignLeft);
    return made;
}

} // namespace

PictureQuestion::PictureQuestion(Workspace& workspace, const QString& path, QWidget* parent)
    : QDialog(parent), m_path(path), m_hasLayers(workspace.sphereMap.map() != nullptr), m_wait(new QLabel(tr("Reading the picture…"))),
      m_probes(row()), m_balls(row()), m_runner(this)
{
    setObjectName(QStringLiteral("pictureQuestion"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("What is this picture?"));
    auto* text = new QLabel(tr("%1 is square: it may be the light of a place, or the picture of a ball. Choose what looks right.")
                                .arg(QFileInfo(path).fileName()));
    text->setWordWrap(true);
    text->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    for (QAbstractButton* button : buttons->buttons())
        button->setToolTip(tr("Leaves the scene as it is"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    column->addWidget(text);
    column->addWidget(m_wait);
    column->addWidget(heading(tr("Light: the environment looks like this")));
    column->addWidget(m_probes);
    column->addWidget(heading(tr("A ball: the material looks like this")));
    column->addWidget(m_balls);
    column->addWidget(buttons);
    connect(&m_runner, &JobRunner::failed, m_wait, &QLabel::setText);
    m_runner.start([path](const JobControl& job) { return picturesOf(path, job); },
                   [this](const Pictures& pictures) { showCards(pictures); });
}

PictureQuestion::Pictures PictureQuestion::picturesOf(const QString& path, const JobControl& job)
{
    const ReducedProbe probe = reduceProbe(toPath(path).string(), {.height = 96}, job);
    double sum = 0.0;
    for (const float value : probe.image.texels)
        sum += static_cast<double>(value);
    const double mean = sum / static_cast<double>(std::max<size_t>(1, probe.image.texels.size()));
    return {probeGuesses(probe, mean > 0.0 ? std::log2(0.25 / mean) : 0.0, job), ballOf(path, job)};
}

void PictureQuestion::showCards(const Pictures& pictures)
{
    m_wait->hide();
    for (const ProbeGuess& guess : pictures.probes) {
        const bool isBall = guess.fit == Fit::Crop;
        makeCard(isBall ? "ball" : std::string(name(guess.kind)).c_str(), guessText(guess), tr("Reads the file as this kind of map"),
                 guess.picture, PictureUse::Probe, {.parameterization = guess.kind, .fit = guess.fit});
    }
    makeCard("sphere-map", tr("sphere map"), tr("The material looks like the ball; the picture stays in its file"), pictures.ball,
             PictureUse::SphereMap, {});
    if (m_hasLayers)
        makeCard("layer", tr("image layer"), tr("A layer of the sphere map that the scene has"), pictures.ball, PictureUse::Layer, {});
    cards().front()->setFocus();
    adjustSize();
    setMinimumHeight(layout()->totalHeightForWidth(width())); // adjustSize() counts a wrapped line as one
}

QToolButton* PictureQuestion::makeCard(const char* id, const QString& text, const QString& help, const QImage& picture, PictureUse use,
                                       const ProbeReading& reading)
{
    QWidget* among = use == PictureUse::Probe ? m_probes : m_balls;
    auto* card = new QToolButton(among);
    card->setObjectName(QStringLiteral("picture.") + QLatin1String(id));
    card->setText(text);
    card->setAccessibleName(text);
    card->setToolTip(help);
    card->setIcon(QIcon(QPixmap::fromImage(picture)));
    card->setIconSize(use == PictureUse::Probe ? environmentSize : QSize(ballEdge, ballEdge));
    card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    card->setFocusPolicy(Qt::StrongFocus);
    connect(card, &QToolButton::clicked, this, [this, use, reading] {
        emit chosen(use, reading);
        accept();
    });
    among->layout()->addWidget(card);
    card->show(); // now, not with the next events: the dialog's size is found at once, and what is hidden has none
    return card;
}

} // namespace mirrorball::studio
