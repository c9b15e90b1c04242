#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mirrorball {

/// What stands for a BRDF's integral: lookups fitted to it (brdf_lookups.h), what an engine of today does (engine_lookups.h), or the
/// integral itself, which is no lookups into a ggx chain but maps of its own (view_stack.h).
enum class LookupKind { Fitted, SplitSum, Three, Filament, Exact };
std::span<const std::string_view> words(LookupKind); // fitted split-sum three filament exact

struct LookupChoice {
    LookupKind kind = LookupKind::Fitted;
    int count = 5; ///< fitted: 1 to 8
    bool operator==(const LookupChoice&) const = default;
};

/// "5" or "lookups:5": so many that are fitted; "split-sum", "three", "filament"; nothing for any other word, nor for "exact".
std::optional<LookupChoice> lookupChoiceFromWord(std::string_view word);
/// "lookups:5", "split-sum", ...
std::string describe(const LookupChoice& choice);
/// What may be written, for messages.
std::string lookupChoiceHelp();

} // namespace mirrorball
