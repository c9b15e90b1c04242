#include "frame_list.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

#include <algorithm>
#include <charconv>

namespace mirrorball {
namespace {

constexpr int mostFrames = 1'000'000;

[[noreturn]] void refuse(const std::string& text)
{
    throw InvalidArgument("must be frames such as 1-24, 1-100x5 or 1-9,20; it is " + inQuotes(text));
}

/// Takes a whole number off the front of `rest`.
int takeNumber(std::string_view& rest, const std::string& text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc() || number < 0 || number >= mostFrames || end == rest.data())
        refuse(text);
    rest.remove_prefix(static_cast<size_t>(end - rest.data()));
    return number;
}

bool takeMark(std::string_view& rest, char mark)
{
    if (rest.empty() || rest.front() != mark)
        return false;
    rest.remove_prefix(1);
    return true;
}

} // namespace

std::vector<int> parseFrames(const std::string& text)
{
    std::vector<int> frames;
    std::string_view rest = text;
    do {
        const int first = takeNumber(rest, text);
        const int last = takeMark(rest, '-') ? takeNumber(rest, text) : first;
        const int step = takeMark(rest, 'x') ? takeNumber(rest, text) : 1;
        if (last < first || step < 1)
            refuse(text);
        for (int frame = first; frame <= last; frame += step)
            frames.push_back(frame);
        if (frames.size() > static_cast<size_t>(mostFrames))
            throw InvalidArgument("has more than " + std::to_string(mostFrames) + " frames; divide them over several jobs files");
    } while (takeMark(rest, ','));
    if (!rest.empty())
        refuse(text);
    std::vector<int> sorted = frames;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
        throw InvalidArgument("names frame " + std::to_string(*twice) + " twice; name each once");
    return frames;
}

std::string replacedAll(std::string text, std::string_view mark, std::string_view word)
{
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + word.size()))
        text.replace(at, mark.size(), word);
    return text;
}

std::string withFrame(std::string_view text, int frame)
{
    const std::string number = std::to_string(frame);
    std::string named;
    for (size_t i = 0; i < text.size();) {
        const size_t end = std::min(text.find_first_not_of('#', i), text.size());
        if (end == i) {
            named += text[i++];
            continue;
        }
        named.append(end - i > number.size() ? end - i - number.size() : 0, '0');
        named += number;
        i = end;
    }
    return replacedAll(std::move(named), "{frame}", number);
}

bool namesFrame(std::string_view text)
{
    return text.find('#') != std::string_view::npos || text.find("{frame}") != std::string_view::npos;
}

} // namespace mirrorball
