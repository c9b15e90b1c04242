#include "lookup_choice.h"

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 5> kindWords{"fitted", "split-sum", "three", "filament", "exact"};
constexpr std::string_view prefix = "lookups:";

} // namespace

std::span<const std::string_view> words(LookupKind) { return kindWords; }

std::optional<LookupChoice> lookupChoiceFromWord(std::string_view word)
{
    for (const LookupKind kind : {LookupKind::SplitSum, LookupKind::Three, LookupKind::Filament}) // "fitted" does not say how many
        if (word == kindWords[static_cast<size_t>(kind)])
            return LookupChoice{kind};
    if (word.starts_with(prefix))
        word.remove_prefix(prefix.size());
    if (word.size() == 1 && word[0] >= '1' && word[0] <= '8')
        return LookupChoice{LookupKind::Fitted, word[0] - '0'};
    return std::nullopt;
}

std::string describe(const LookupChoice& choice)
{
    if (choice.kind == LookupKind::Fitted)
        return std::string(prefix) + std::to_string(choice.count);
    return std::string(kindWords[static_cast<size_t>(choice.kind)]);
}

std::string lookupChoiceHelp() { return "lookups:K (1 to 8), split-sum, three or filament"; }

} // namespace mirrorball
