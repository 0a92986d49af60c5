#include "base/files/npy_header.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstddef>

namespace poissonlab {

std::string_view npy_byte_order() { return std::endian::native == std::endian::little ? "<" : ">"; }

std::string npy_header_of(std::string_view descr, std::string_view shape)
{
    // The numbers start at a multiple of 64 bytes; blanks and an end of line fill the header up to there.
    constexpr std::string_view magic = "\x93NUMPY";
    constexpr std::size_t alignment = 64;
    constexpr std::size_t before_header = magic.size() + 2 + 2;
    std::string header = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}", descr, shape);
    const std::size_t unpadded = before_header + header.size() + 1;
    header.append((alignment - unpadded % alignment) % alignment, ' ');
    header += '\n';
    return fmt::format("{}{}{}{}", magic, std::string_view("\x01\x00", 2),
                       std::string{static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)},
                       header);
}

}
