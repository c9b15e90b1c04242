#include "frames.h"

#include "command.h"

#include "core/base/error.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mirrorball::cli {

namespace {

constexpr int mostFrames = 1'000'000;

/// Frames as ranges: "1003, 1007-1009".
std::string listed(std::vector<int> frames)
{
    std::sort(frames.begin(), frames.end());
    std::string text;
    for (size_t i = 0; i < frames.size();) {
        size_t end = i + 1;
        while (end < frames.size() && frames[end] == frames[end - 1] + 1)
            ++end;
        text += (text.empty() ? "" : ", ") + std::to_string(frames[i]) + (end > i + 1 ? "-" + std::to_string(frames[end - 1]) : "");
        i = end;
    }
    return text;
}

} // namespace

FrameRange parseFrames(const std::string& text)
{
    FrameRange range;
    const char* end = text.data() + text.size();
    auto [next, error] = std::from_chars(text.data(), end, range.first);
    bool good = error == std::errc() && range.first >= 0;
    range.last = range.first;
    if (good && next != end) {
        good = *next == '-';
        if (good) {
            const auto second = std::from_chars(next + 1, end, range.last);
            good = second.ec == std::errc() && second.ptr == end;
        }
    }
    if (!good || range.last < range.first || range.last - range.first >= mostFrames)
        throw InvalidArgument("--frames: '" + text + "' is no range of frames; give FIRST-LAST, such as 1001-1100, at most a million");
    return range;
}

std::string withFrame(const std::string& text, int frame)
{
    const std::string number = std::to_string(frame);
    std::string result;
    for (size_t i = 0; i < text.size();) {
        if (text[i] != '#') {
            result += text[i++];
            continue;
        }
        size_t end = i;
        while (end < text.size() && text[end] == '#')
            ++end;
        result.append(end - i > number.size() ? end - i - number.size() : 0, '0');
        result += number;
        i = end;
    }
    return result;
}

void forFrames(const std::string& frames, std::initializer_list<std::string> outputs, int threads, FramesAtOnce atOnce,
               const std::function<void(int frame, const JobControl& job)>& body)
{
    forFrames("--frames", parseFrames(frames), outputs, threads, atOnce, body);
}

void forFrames(const std::string& option, const FrameRange& range, std::initializer_list<std::string> outputs, int threads,
               FramesAtOnce atOnce, const std::function<void(int frame, const JobControl& job)>& body)
{
    for (const std::string& output : outputs)
        if (range.count() > 1 && !output.empty() && output.find('#') == std::string::npos)
            throw InvalidArgument(option + ": every frame would be written to '" + output +
                                  "'; put #### in its name, for the frame's number");
    const JobControl whole = jobWithProgress("frames", threads);
    const int workers = atOnce == FramesAtOnce::One ? 1 : std::min(whole.threadCount(), range.count());
    const JobControl each{.stop = whole.stop, .progress = {}, .threads = workers > 1 ? 1 : whole.threads};
    std::mutex mutex; // guards what follows
    std::vector<int> missing;
    std::exception_ptr failed;
    int done = 0;
    std::atomic<int> next{range.first};
    std::atomic<bool> ends{false};
    const auto work = [&] {
        for (int frame = next++; frame <= range.last && !ends; frame = next++) {
            try {
                each.checkStop();
                body(frame, each);
            } catch (const FileError& error) {
                const std::lock_guard lock(mutex);
                std::fprintf(stderr, "mirrorball: frame %d is left out: %s\n", frame, error.what());
                missing.push_back(frame);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failed)
                    failed = std::current_exception();
                ends = true;
            }
            const std::lock_guard lock(mutex);
            if (whole.progress)
                whole.progress(static_cast<float>(++done) / static_cast<float>(range.count()));
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < workers; ++i)
            others.emplace_back(work);
        work();
    }
    if (failed)
        std::rethrow_exception(failed);
    if (!missing.empty())
        throw WorkError(std::to_string(missing.size()) + " of " + std::to_string(range.count()) +
                        " frames were left out: " + listed(missing) + "; see the lines above");
}

} // namespace mirrorball::cli
