#pragma once

#include <exception>
#include <new>
#include <string>

namespace mirrorball {

/// What went wrong, in a line for people: an Error says it itself; what the standard library throws gets words.
inline std::string messageOf(const std::exception& failure)
{
    if (dynamic_cast<const std::bad_alloc*>(&failure))
        return "there is not enough memory for this; make maps or pictures smaller, or close other programs";
    return failure.what();
}

/// Runs `work` and returns what went wrong; empty where nothing did.
template <typename Work>
std::string failureOf(Work&& work)
{
    try {
        work();
        return {};
    } catch (const std::exception& failure) {
        const std::string message = messageOf(failure);
        return message.empty() ? "an error without a message" : message;
    } catch (...) {
        return "an error that says nothing of itself";
    }
}

} // namespace mirrorball
