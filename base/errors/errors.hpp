// Errors of three kinds: those that the user can mend, those that OpenCL reports, and those of files.
//
// Their messages are one line each, although they hold names and values that can be anything: what would end the line
// or command a terminal is escaped, see printable(). Text that is printable already stays as it is. `details` are lines
// for the reader that follow the message verbatim, such as what a program said.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace poissonlab {

/// A place in an input: a line of a file, a whole file (line 0), or an argument of the command line.
struct SourceLocation
{
    std::string file; ///< or the argument, such as "--set seed=2"
    int line = 0;
    bool is_argument = false;
};

/// "file:line", or "file" where there is no line.
std::string to_string(const SourceLocation& location);

/// Something the user can mend: a config key, a point file, an argument. Exit status 2.
///
/// The message names the place, the value and what is allowed. Code that needs these asks for them and never takes the
/// message apart.
class InputError : public std::runtime_error
{
public:
    explicit InputError(std::string_view message, std::string_view details = {});

    /// `place: problem`.
    static InputError at(SourceLocation place, std::string_view problem);

    /// An error with this problem at another place.
    InputError moved_to(SourceLocation place) const;

    // Each is empty where the error has none.
    const SourceLocation& place() const { return place_; }
    const std::string& key() const { return key_; }
    const std::string& value() const { return value_; }
    const std::string& allowed() const { return allowed_; }

private:
    friend InputError invalid_value(const SourceLocation& location, const std::string& key, const std::string& value,
                                    const std::string& allowed);

    SourceLocation place_;
    std::string problem_; ///< the message without the place
    std::string key_, value_, allowed_;
};

/// The InputError for a key with a value that is not allowed:
/// `file:line: key = value: allowed`, for example
/// `quick.toml:12: relative_radius = 1.5: must be a number from 0 to 1`. Long keys and values are shortened in the
/// message. Without a location it begins with the key.
InputError invalid_value(const SourceLocation& location, const std::string& key, const std::string& value,
                         const std::string& allowed);

/// A failed OpenCL call, a kernel that does not build, no device at all. Exit status 3.
class DeviceError : public std::runtime_error
{
public:
    explicit DeviceError(std::string_view message, std::string_view details = {});
};

/// A file system operation that failed for reasons outside the input: full disk, no permission. Exit
/// status 1.
class StorageError : public std::runtime_error
{
public:
    explicit StorageError(std::string_view message, std::string_view details = {});
};

/// `text` with control characters, and bytes that are no UTF-8, as \n, \t or \x1b: one line on any terminal.
std::string printable(std::string_view text);

/// `text`, or its beginning and "..." where it has more than `longest` bytes: messages quote what they are about, not
/// all of it. Characters of UTF-8 are left whole.
std::string shortened(std::string_view text, std::size_t longest = 60);

}
