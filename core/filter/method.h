#pragma once

#include "paraboloid.h"

#include "core/base/fields.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The filtering methods by name, and the knobs that some of them have.
namespace mirrorball {

/// Each has a file of its own, where its row is (method_row.h); prefilter.h is the one interface over them.
enum class Method { Auto, Reference, Spectral, Direct, Hierarchical, Importance, Paraboloid, Mip, Sh9 };

inline constexpr std::array allMethods{Method::Auto,       Method::Reference,  Method::Spectral, Method::Direct, Method::Hierarchical,
                                       Method::Importance, Method::Paraboloid, Method::Mip,      Method::Sh9};

/// "auto", "reference", "spectral", "direct", "hierarchical", "importance", "paraboloid", "mip", "sh9"
std::string_view name(Method method);
std::optional<Method> methodFromName(std::string_view word);
/// What it does, in one line without a full stop.
std::string_view helpOf(Method method);

/// The knobs that belong to a method: names of fields of MethodKnobs.
std::span<const std::string_view> knobsOf(Method method);
bool hasKnob(Method method, std::string_view knob);
/// The methods that a knob belongs to: "importance". Empty where it is no knob.
std::string ownersOf(std::string_view knob);
/// Whether a smaller tolerance costs a method more, so that the tolerance is its knob.
bool followsTolerance(Method method);

/// How the pyramid of the mip method is filtered at the edges of cube faces.
enum class MipFiltering {
    AcrossSeams, ///< consistently, as 002 asks for
    PerFace      ///< each face by itself with clamped lookups, as the hardware of 2002 did: shows seams
};
std::span<const std::string_view> words(MipFiltering); // across-seams per-face

/// What is particular to one method, whose row names it (knobsOf()); the others do not look at it. The tolerance, which is the knob of
/// spectral, direct and hierarchical, belongs to all (PrefilterOptions).
struct MethodKnobs {
    int samples = 1024;             ///< importance: samples of the lobe a texel
    std::optional<double> lambda{}; ///< mip: least level of detail; empty: matched to the lobe by width
    MipFiltering mipFiltering = MipFiltering::AcrossSeams;
    ParaboloidKnobs paraboloid{};

    bool operator==(const MethodKnobs&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"samples", "importance: samples of the lobe a texel", 1, 1 << 20}, self.samples);
        visit(Field{"lambda", "mip: least level of detail of the environment; without it matched to the lobe by width", 0, 32, "levels"},
              self.lambda);
        visit(Field{"mip_filtering", "mip: cube faces filtered across their seams, or each by itself as the hardware of 2002 did"},
              self.mipFiltering);
        ParaboloidKnobs::visitFields(self.paraboloid, visit);
    }
};

} // namespace mirrorball
