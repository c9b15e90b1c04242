#include "content_form.h"

#include "core/image/builtin_probes.h"
#include "core/shading/conductor.h"

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
            {"source",
             {.suggestions = probes,
              .fileFilter = ContentForm::tr("Images (*.exr *.hdr *.tif *.tiff *.png *.jpg *.jpeg *.tga *.bmp);;All files (*)")}},
            {"metal", {.suggestions = metals}},
        };
    }();
    return styles;
}

} // namespace

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
                        layerStyles());
                else
                    SettingsForm::show(settings);
                QWidget::show();
            }
        },
        content);
}

} // namespace mirrorball::studio
