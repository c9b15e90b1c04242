#pragma once

#include "core/scene/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

/// What tests ask of a plan's decisions. Their words are plan_words_test.cpp's.
namespace mirrorball::test {

/// Null where there is no such stage.
inline const PlannedStage* findStage(const Plan& plan, const std::string& name)
{
    const auto found = std::find_if(plan.decisions.begin(), plan.decisions.end(), [&](const PlannedStage& s) { return s.name == name; });
    return found == plan.decisions.end() ? nullptr : &*found;
}

inline const PlannedStage& stage(const Plan& plan, const std::string& name)
{
    static const PlannedStage none{.name = "none"};
    const PlannedStage* found = findStage(plan, name);
    if (!found)
        ADD_FAILURE() << "no stage " << name;
    return found ? *found : none;
}

/// The numbers of a decision of this kind; a failure and none where it is another.
template <typename Kind>
Kind decided(const Plan& plan, const std::string& name, bool isLeftOut)
{
    const PlannedStage& found = stage(plan, name);
    EXPECT_EQ(found.isLeftOut, isLeftOut) << name;
    const Kind* numbers = std::get_if<Kind>(&found.why);
    if (!numbers)
        ADD_FAILURE() << name << " is decided for another reason, number " << found.why.index();
    return numbers ? *numbers : Kind{};
}

template <typename Kind>
Kind needed(const Plan& plan, const std::string& name)
{
    return decided<Kind>(plan, name, false);
}

template <typename Kind>
Kind leftOut(const Plan& plan, const std::string& name)
{
    return decided<Kind>(plan, name, true);
}

inline void expectLeftOut(const Plan& plan, const std::string& name, Because because)
{
    EXPECT_EQ(decided<Because>(plan, name, true), because) << name;
}

} // namespace mirrorball::test
