#include "base/images/png_damage.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace poissonlab {
namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// Reads so many bytes; fewer at the end of the file.
std::string_view read_bytes(std::ifstream& file, std::string& space, std::size_t count)
{
    space.resize(count);
    file.read(space.data(), static_cast<std::streamsize>(count));
    return std::string_view(space).substr(0, static_cast<std::size_t>(file.gcount()));
}

/// The check sum of a chunk of this type, whose data comes next in the file; false where the file ends before.
bool read_check_sum(std::ifstream& file, std::string& space, std::string_view type, std::uint32_t length,
                    std::uint32_t& sum)
{
    boost::crc_32_type crc;
    crc.process_bytes(type.data(), type.size());
    while (length > 0) {
        const std::string_view bytes = read_bytes(file, space, std::min(length, std::uint32_t{1} << 16));
        if (bytes.empty()) return false;
        crc.process_bytes(bytes.data(), bytes.size());
        length -= static_cast<std::uint32_t>(bytes.size());
    }
    sum = crc.checksum();
    return true;
}

/// Says what is wrong with the chunks before the first one of the type `last`, or with all up to the end if none has
/// it.
std::string damage_before(const std::filesystem::path& path, std::string_view last)
{
    std::ifstream file(path, std::ios::binary);
    std::string space;
    if (read_bytes(file, space, png_signature.size()) != png_signature) return {};
    for (std::string type; type != "IEND";) {
        const std::string_view head = read_bytes(file, space, 8);
        if (head.size() < 8) return "the file is cut off";
        const auto length = load<std::uint32_t>(head, std::endian::big);
        type = head.substr(4);
        if (type == last) return {};
        std::uint32_t sum = 0;
        if (!read_check_sum(file, space, type, length, sum)) return "the file is cut off";
        const std::string_view stored = read_bytes(file, space, 4);
        if (stored.size() < 4) return "the file is cut off";
        if (load<std::uint32_t>(stored, std::endian::big) != sum)
            return "the file is damaged: its chunk " + printable(type) + " has another check sum";
    }
    return {};
}

}

std::string png_damage(const std::filesystem::path& path) { return damage_before(path, ""); }

std::string png_header_damage(const std::filesystem::path& path) { return damage_before(path, "IDAT"); }

}
