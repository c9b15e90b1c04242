#pragma once

#include <stdexcept>
#include <string>

/// Errors. Every message names what failed, which file, option or field it concerns, and what to do about it, in one line.
/// They are caught in three places only: the command line's main, the studio's job runner and its action handler.
namespace mirrorball {

/// Base of all errors that a user or the outside world can cause. Programming mistakes are asserts, not errors.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The work failed though the request was in order: a full disk, a missing GL context. The command line exits with 1.
class WorkError : public Error {
public:
    using Error::Error;
};

/// The arguments or the input are wrong: an option out of range, a broken file. The command line exits with 2.
class InvalidArgument : public Error {
public:
    using Error::Error;
};

/// A path as a message shows it: in one line, and so short that the rest of the message is seen. Control characters become '?'; of a path
/// of more than 300 bytes the beginning and the end remain. Paths come from files that are not trusted.
std::string shownPath(const std::string& path);

/// An input file is missing, damaged, too large or not what it claims to be. Exits with 2.
class FileError : public InvalidArgument {
public:
    FileError(const std::string& path, const std::string& message) : InvalidArgument(shownPath(path) + ": " + message) {}
};

/// The caller asked for the work to stop (JobControl). Nothing was written.
class Cancelled : public Error {
public:
    Cancelled() : Error("cancelled") {}
};

} // namespace mirrorball
