#include "base/regions/region_text.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

namespace poissonlab {
namespace {

/// Coordinates that are ten times as far from 0 as they are from each other are places on the globe, where they
/// could be.
constexpr double far_away = 10;

bool begins_with(std::string_view text, std::string_view word)
{
    return text.size() >= word.size() && std::ranges::equal(text.substr(0, word.size()), word, [](char a, char b) {
               return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
           });
}

bool is_wkt(std::string_view text)
{
    return begins_with(text, "POLYGON") || begins_with(text, "MULTIPOLYGON") || begins_with(text, "SRID=");
}

std::string_view without_blanks_around(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a mark of byte order
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// The numbers after the first word, if there are so many and no others.
std::optional<std::vector<double>> numbers_after_word(std::string_view text, std::size_t count)
{
    std::vector<double> numbers;
    WordReader words(text);
    for (words.next(); words.next();) {
        double number = 0;
        if (!parse_number(words.word(), number) || !std::isfinite(number)) return {};
        numbers.push_back(number);
    }
    if (numbers.size() != count) return {};
    return numbers;
}

PlaneRegion rectangle_of(const std::string& text)
{
    const auto n = numbers_after_word(text, 4);
    if (!n || !((*n)[0] < (*n)[2]) || !((*n)[1] < (*n)[3]))
        throw InputError(shortened(printable(text)) + ": must be rectangle X0 Y0 X1 Y1 with X0 < X1 and Y0 < Y1");
    const double x0 = (*n)[0], y0 = (*n)[1], x1 = (*n)[2], y1 = (*n)[3];
    PlaneRegion region;
    region.polygons.emplace_back().outline = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return region;
}

PlaneRegion disk_of(const std::string& text)
{
    const auto n = numbers_after_word(text, 3);
    if (!n || !((*n)[2] > 0))
        throw InputError(shortened(printable(text)) + ": must be disk X Y RADIUS with RADIUS > 0");
    PlaneRegion region;
    RegionRing& ring = region.polygons.emplace_back().outline;
    for (int i = 0; i < disk_corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / disk_corners;
        ring.push_back({(*n)[0] + (*n)[2] * std::cos(angle), (*n)[1] + (*n)[2] * std::sin(angle)});
    }
    return region;
}

/// Could the coordinates be longitudes and latitudes?
bool fits_globe(const RegionBox& box)
{
    return box.low[0] >= -180 && box.high[0] <= 180 && box.low[1] >= -90 && box.high[1] <= 90;
}

bool is_far_away(const RegionBox& box)
{
    double nearest = 0;
    for (std::size_t k = 0; k < 2; ++k)
        if (box.low[k] > 0 || box.high[k] < 0)
            nearest = std::max(nearest, std::min(std::abs(box.low[k]), std::abs(box.high[k])));
    return nearest > far_away * box.longest();
}

void refuse_degrees(const PlaneRegion& region, const std::string& name, const std::string& why)
{
    const RegionBox box = box_of(region);
    throw InputError(
        fmt::format("{}: {}: coordinates from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) look like longitude and latitude, "
                    "whose degrees are no lengths: project them to metres, or say that they are lengths (planar)",
                    name, why, box.low[0], box.low[1], box.high[0], box.high[1]));
}

PlaneRegion read_wkt(std::string_view text, const std::string& name, bool is_planar)
{
    bool says_degrees = false, says_metres = false;
    if (begins_with(text, "SRID=")) {
        const std::size_t end = text.find(';');
        if (end == std::string_view::npos) throw InputError(name + ": is not WKT: no ; after SRID=");
        const std::string_view system = text.substr(5, end - 5);
        says_degrees = system == "4326" || system == "4269" || system == "4258";
        says_metres = !says_degrees;
        text = without_blanks_around(text.substr(end + 1));
    }
    PlaneRegion region = region_of_wkt(std::string(text), name);
    check_region(region, name);
    if (is_planar || says_metres) return region;
    const RegionBox box = box_of(region);
    if (says_degrees) refuse_degrees(region, name, "its SRID is one of degrees");
    if (fits_globe(box) && is_far_away(box)) refuse_degrees(region, name, "it is small and far from 0");
    return region;
}

}

bool is_region_text(std::string_view text)
{
    const std::string_view begin = without_blanks_around(text);
    return begin.starts_with('{') || is_wkt(begin) || begins_with(begin, "rectangle ") || begins_with(begin, "disk ");
}

PlaneRegion read_region(const std::string& text, bool is_planar)
{
    const bool is_file = !is_region_text(text);
    const std::string name = is_file ? printable(text) : shortened(printable(text), 40);
    const std::string content = is_file ? read_whole_file(text) : text;
    const std::string_view begin = without_blanks_around(content);
    if (begin.starts_with('{')) {
        bool says_metres = false;
        PlaneRegion region = region_of_geojson(content, name, says_metres);
        check_region(region, name);
        if (!is_planar && !says_metres && fits_globe(box_of(region)))
            refuse_degrees(region, name, "GeoJSON without another crs");
        return region;
    }
    if (is_wkt(begin)) return read_wkt(begin, name, is_planar);
    if (!is_region_text(begin))
        throw InputError(name + ": is neither GeoJSON nor WKT, nor rectangle X0 Y0 X1 Y1, nor disk X Y RADIUS");
    PlaneRegion region = begins_with(begin, "disk ") ? disk_of(std::string(begin)) : rectangle_of(std::string(begin));
    check_region(region, name);
    return region;
}

}
