#include "reports/radial_table.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace poissonlab {

namespace {

constexpr auto header = "frequency,power,anisotropy_db,samples,power_error";

// The five numbers of a line; false when it holds anything else.
bool parse_line(const std::string& line, std::array<double, 5>& values)
{
    const char* position = line.data();
    const char* const end = line.data() + line.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0 && (position == end || *position++ != ',')) return false;
        const auto [next, error] = std::from_chars(position, end, values[i]);
        if (error != std::errc{}) return false;
        position = next;
    }
    return position == end && std::isfinite(values[0]) && std::isfinite(values[1]);
}

}

std::vector<RadialBin> read_radial_table(const std::filesystem::path& path)
{
    std::istringstream text(read_whole_file(path));
    std::string line;
    if (!std::getline(text, line) || line != header)
        throw InputError(path.string() + ":1: must be the header " + header);

    std::vector<RadialBin> bins;
    std::array<double, 5> values{};
    for (int number = 2; std::getline(text, line); ++number) {
        if (!parse_line(line, values))
            throw InputError(path.string() + ":" + std::to_string(number) + ": must be five numbers, not '" +
                             line + "'");
        bins.push_back({values[0], values[1], values[2], static_cast<std::size_t>(values[3]), values[4]});
    }
    if (bins.empty()) throw InputError(path.string() + ": holds no frequencies");
    return bins;
}

RadialBin peak_power(const std::vector<RadialBin>& bins)
{
    return *std::ranges::max_element(bins, {}, &RadialBin::power);
}

}
