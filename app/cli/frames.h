#pragma once

#include "core/base/job.h"

#include <functional>
#include <initializer_list>
#include <string>

/// Sequences: `--frames A-B`, with #### in names for the number of a frame.
namespace mirrorball::cli {

struct FrameRange {
    int first = 0, last = 0; ///< both are made
    int count() const { return last - first + 1; }
};

/// "1001-1100", or one number. @throws InvalidArgument for anything else, a range that runs backwards or is longer than a million
FrameRange parseFrames(const std::string& text);

/// The text with its runs of # replaced by the frame's number, with zeros in front up to the run's length.
std::string withFrame(const std::string& text, int frame);

enum class FramesAtOnce {
    One,    ///< what draws with OpenGL, or is given its own threads
    PerCore ///< each on one thread: while one is read or written another is computed
};

/// Runs `body` for every frame, with the job of one frame. A frame whose files are missing or damaged (FileError) is named on stderr, and
/// the others go on; any other error ends the sequence. Memory is that of the frames at work, however many there are.
/// @param outputs  the names that the frames' files are written to: each needs a #, or the frames would overwrite one another
/// @throws InvalidArgument for an output without #; WorkError at the end when frames were left out, naming them
void forFrames(const std::string& frames, std::initializer_list<std::string> outputs, int threads, FramesAtOnce atOnce,
               const std::function<void(int frame, const JobControl& job)>& body);
/// The same for frames that another option asks for. @param option  for messages, "--turntable"
void forFrames(const std::string& option, const FrameRange& range, std::initializer_list<std::string> outputs, int threads,
               FramesAtOnce atOnce, const std::function<void(int frame, const JobControl& job)>& body);

} // namespace mirrorball::cli
