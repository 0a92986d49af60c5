#include "base/errors/errors.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace poissonlab {
namespace {

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The number of bytes of the character of UTF-8 that `text` begins with; 0: it begins with none that can be shown, but
/// with a control character (C0, DEL or C1), a surrogate, a longer form than needed, or some other byte.
std::size_t shown_length(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    std::uint32_t character = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (!is_continuation(text[i])) return 0;
        character = character << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0xA0, 0x800, 0x10000}; // below 0xA0: C1
    const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
    return character >= smallest[length] && character <= 0x10FFFF && !is_surrogate ? length : 0;
}

std::string escaped(char byte)
{
    if (byte == '\n') return "\\n";
    if (byte == '\r') return "\\r";
    if (byte == '\t') return "\\t";
    constexpr std::string_view digits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    return {'\\', 'x', digits[value >> 4], digits[value & 15U]};
}

}

InputError::InputError(std::string_view message, std::string_view details)
    : std::runtime_error(printable(message).append(details)), problem_(what())
{}

InputError InputError::at(SourceLocation place, std::string_view problem)
{
    return InputError(problem).moved_to(std::move(place));
}

InputError InputError::moved_to(SourceLocation place) const
{
    // The problem is printable already, or has details, which stay as they are.
    InputError moved(place.file.empty() ? "" : to_string(place) + ": ", problem_);
    moved.place_ = std::move(place);
    moved.problem_ = problem_;
    moved.key_ = key_;
    moved.value_ = value_;
    moved.allowed_ = allowed_;
    return moved;
}

DeviceError::DeviceError(std::string_view message, std::string_view details)
    : std::runtime_error(printable(message).append(details))
{}

StorageError::StorageError(std::string_view message, std::string_view details)
    : std::runtime_error(printable(message).append(details))
{}

std::string printable(std::string_view text)
{
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = shown_length(text);
        if (length > 0)
            result += text.substr(0, length);
        else
            result += escaped(text.front());
        text.remove_prefix(length > 0 ? length : 1);
    }
    return result;
}

std::string shortened(std::string_view text, std::size_t longest)
{
    if (text.size() <= longest) return std::string(text);
    std::size_t end = longest;
    while (end > 0 && is_continuation(text[end])) --end;
    // Bytes that are no UTF-8 may all look like continuations.
    return std::string(text.substr(0, end > 0 ? end : longest)) + "...";
}

std::string to_string(const SourceLocation& location)
{
    return location.line > 0 ? location.file + ":" + std::to_string(location.line) : location.file;
}

InputError invalid_value(const SourceLocation& location, const std::string& key, const std::string& value,
                         const std::string& allowed)
{
    InputError error(shortened(key) + " = " + shortened(value, 200) + ": " + allowed);
    error.key_ = key;
    error.value_ = value;
    error.allowed_ = allowed;
    return error.moved_to(location);
}

}
