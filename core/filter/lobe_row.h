#pragma once

#include "lobe.h"

#include <array>
#include <string_view>

namespace mirrorball {

/// What a kind of lobe is called and what it is like, wherever that is written, typed, read or reckoned with: one row a kind. What it
/// evaluates to is in lobe.cpp. Nothing has a default, so that a row that lacks something is warned of.
struct LobeRow {
    LobeKind kind;
    std::string_view word;      ///< of files, commands and reports
    std::string_view parameter; ///< the option and the key of its number; empty: it has none
    double Lobe::*value;        ///< its number; null: it has none
    Lobe (*make)(double value); ///< @throws InvalidArgument where the number is out of range. Null: no word makes such a lobe
    bool isProduct;             ///< k takes a few products and no power
    bool hasLongTail;           ///< k falls like a power of the angle, so that blocks of texels are cut small far from the peak, too
};

/// In the order of LobeKind.
inline constexpr std::array lobeRows{
    LobeRow{.kind = LobeKind::Phong,
            .word = "phong",
            .parameter = "exponent",
            .value = &Lobe::exponent,
            .make = phongLobe,
            .isProduct = false,
            .hasLongTail = false},
    LobeRow{.kind = LobeKind::Diffuse,
            .word = "diffuse",
            .parameter = "",
            .value = nullptr,
            .make = [](double) { return diffuseLobe(); },
            .isProduct = true,
            .hasLongTail = false},
    LobeRow{.kind = LobeKind::Ggx,
            .word = "ggx",
            .parameter = "alpha",
            .value = &Lobe::alpha,
            .make = ggxLobe,
            .isProduct = true,
            .hasLongTail = true},
    LobeRow{.kind = LobeKind::Tabulated,
            .word = "tabulated",
            .parameter = "",
            .value = nullptr,
            .make = nullptr,
            .isProduct = false,
            .hasLongTail = false},
};

/// Whether every kind has its row. A kind that is new here gets a case, or the compiler names it.
consteval bool lobeRowsAreWhole()
{
    for (size_t i = 0; i < lobeRows.size(); ++i) {
        const LobeRow& row = lobeRows[i];
        if (static_cast<size_t>(row.kind) != i || row.word.empty() || row.parameter.empty() != (row.value == nullptr))
            return false;
    }
    switch (lobeRows.back().kind) {
    case LobeKind::Phong:
    case LobeKind::Diffuse:
    case LobeKind::Ggx:
        return false; // others follow
    case LobeKind::Tabulated:
        break;
    }
    return true;
}
static_assert(lobeRowsAreWhole(), "every kind of lobe has its row, in the order of LobeKind");

constexpr const LobeRow& rowOf(LobeKind kind) { return lobeRows[static_cast<size_t>(kind)]; }

} // namespace mirrorball
