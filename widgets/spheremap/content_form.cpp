#include "content_form.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/image_patterns.h"

#include "core/image/builtin_probes.h"
#include "core/shading/conductor.h"

#include <algorithm>

namespace mirrorball::studio {

namespace {

const FieldStyles& layerStyles()
{
    static const FieldStyles styles = [] {
        QStringList probes, metals;
        for (const BuiltinProbe& probe : builtinProbes())
            probes << QStringLiteral("builtin:") + toQString(probe.name);
        for (const Conductor& metal : conductors())
            metals << toQString(metal.name);
        return FieldStyles{
            {"unit", {.label = ContentForm::tr("Widths in")}},
            {"reference", {.label = ContentForm::tr("Drawn at")}},
            {"exponent", {.sliderLow = 1.0, .sliderHigh = 2000.0, .scale = Scale::Logarithmic}},
            {"exposure", {.sliderLow = -8.0, .sliderHigh = 8.0, .step = 0.1}},
            {"intensity", {.sliderLow = 0.0, .sliderHigh = 8.0}},
            {"diffuse", {.sliderLow = 0.0, .sliderHigh = 2.0}},
            {"index", {.sliderLow = 1.0, .sliderHigh = 3.0}},
            {"yaw", {.sliderLow = -180.0, .sliderHigh = 180.0}},
            {"pitch", {.sliderLow = 200.0, .sliderHigh = 10000.0, .scale = Scale::Logarithmic}},
            {"value", {.sliderLow = 0.0, .sliderHigh = 4.0}},
            {"saturation", {.sliderLow = 0.0, .sliderHigh = 4.0}},
            {"frame", {.sliderLow = 0.0, .sliderHigh = 0.5}},
            {"rings", {.sliderLow = 0.0, .sliderHigh = 10.0}},
            {"density", {.sliderLow = 1.0, .sliderHigh = 200.0, .scale = Scale::Logarithmic}},
            {"source", {.suggestions = probes, .fileFilter = imageFilter()}},
            {"metal", {.names = metals}},
        };
    }();
    return styles;
}

/// A picture of a ball is a file; there are none built in.
template <typename Kind>
FieldStyles stylesOf()
{
    FieldStyles styles = layerStyles();
    if constexpr (std::is_same_v<Kind, ImageLayer>) {
        styles["source"].suggestions.clear();
        styles["exposure"].label = ContentForm::tr("Brightness"); // exposure is the picture's
    }
    return styles;
}

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether a parameter has an effect with the choices made. Numbers that are 0 are no choices: a slider must not make others come and go.
template <typename Kind>
bool isUsed(const Kind&, std::string_view)
{
    return true;
}

bool isUsed(const GradientLayer& layer, std::string_view name)
{
    const GradientShape shape = layer.shape;
    if (isOneOf(name, {"center-x", "center-y"}))
        return shape != GradientShape::Shaded;
    if (name == "radius")
        return shape == GradientShape::Radial || shape == GradientShape::Linear;
    if (name == "angle")
        return shape == GradientShape::Linear || shape == GradientShape::Angular;
    if (name == "repeat") // the others run from 0 to 1
        return shape == GradientShape::Radial || shape == GradientShape::Linear;
    return !isOneOf(name, {"azimuth", "polar"}) || shape == GradientShape::Shaded;
}

bool isUsed(const ColorgramLayer& layer, std::string_view name)
{
    const bool isGrating = layer.source == ColorgramSource::Grating;
    if (name == "groove-angle")
        return isGrating && layer.grooves == Grooves::Straight;
    if (name == "twist") // pieces that are turned every way already have none
        return !isGrating || layer.grooves != Grooves::Scattered;
    if (isOneOf(name, {"pitch", "orders", "grooves", "azimuth", "polar", "spread", "intensity"}))
        return isGrating;
    return !isOneOf(name, {"stops", "rings", "sweep", "arcs", "ripple", "center-softness"}) || !isGrating;
}

bool isUsed(const ProbeLayer& layer, std::string_view name)
{
    if (name == "exponent")
        return layer.lobe == ProbeLobe::Phong;
    if (name == "roughness")
        return layer.lobe == ProbeLobe::Ggx;
    if (name == "index")
        return layer.fresnel == FresnelKind::Dielectric;
    if (name == "metal")
        return layer.fresnel == FresnelKind::Conductor;
    return name != "share" || layer.fresnel != FresnelKind::None;
}

bool isUsed(const HatchingLayer& layer, std::string_view name)
{
    if (isOneOf(name, {"azimuth", "polar"}))
        return layer.tone == HatchingTone::Shade;
    return !isOneOf(name, {"cross-angle", "cross-from"}) || layer.cross;
}

bool isUsed(const ToonLayer& layer, std::string_view name)
{
    return !isOneOf(name, {"count", "shade-color", "light-color", "shade-end"}) || layer.bands.empty();
}

bool isUsed(const PhongLightsLayer& layer, std::string_view name) { return name != "match" || layer.model == PhongModel::NH; }

bool isUsed(const PaintLayer& layer, std::string_view name) { return name != "reference" || layer.unit == WidthUnit::Pixels; }

bool isUsed(const ImageLayer& layer, std::string_view name) { return name != "tint" || layer.pass != ImagePass::Specular; }

} // namespace

QString askForImage(QWidget* parent)
{
    return askForFile(parent,
                      {.purpose = QStringLiteral("layer"), .title = ContentForm::tr("Open a picture of a ball"), .filter = imageFilter()});
}

ContentForm::ContentForm(EditContent edit, QWidget* parent) : SettingsForm(parent), m_edit(std::move(edit)) {}

void ContentForm::showContent(const LayerContent& content)
{
    const bool isNew = m_kind != content.index();
    m_kind = content.index();
    std::visit(
        [&](const auto& settings) {
            using Kind = std::decay_t<decltype(settings)>;
            if constexpr (std::is_same_v<Kind, UnknownLayer>) {
                QWidget::hide();
            } else {
                if (isNew)
                    build<Kind>(
                        settings,
                        [this](const QString& label, const QString& key, const std::function<void(Kind&)>& change) {
                            m_edit(label, key, [&](LayerContent& changed) {
                                if (auto* same = std::get_if<Kind>(&changed))
                                    change(*same);
                            });
                        },
                        stylesOf<Kind>(), [](const Kind& layer, std::string_view name) { return isUsed(layer, name); });
                else
                    SettingsForm::show(settings);
                QWidget::show();
            }
        },
        content);
}

} // namespace mirrorball::studio
