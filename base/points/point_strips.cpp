#include "base/points/point_strips.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

namespace poissonlab {
namespace {

constexpr double points_per_strip = 0x1p20;

/// Limits the number of strips, so that each is higher than six times the distance of neighbours that are as far apart
/// as possible in 3D, even where no more than a third of the expected points come.
constexpr double strips_per_spacing = 0.15;

constexpr double least_strips = 4, most_strips = 4096;

constexpr std::size_t buffered_numbers = std::size_t{1} << 15;

using StripFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail_at(const std::filesystem::path& file)
{
    throw StorageError(
        fmt::format("{}: points in between cannot be kept: {}", file.string(), std::generic_category().message(errno)));
}

}

PointStrips::PointStrips(std::filesystem::path folder, int dimension, std::uint64_t expected)
    : folder_(std::move(folder)), dimension_(dimension)
{
    const auto n = static_cast<double>(expected);
    const double strips = std::min(n / points_per_strip, strips_per_spacing * std::cbrt(n));
    buffers_.resize(static_cast<std::size_t>(std::clamp(strips, least_strips, most_strips)));
}

std::filesystem::path PointStrips::file_of(std::size_t strip) const { return folder_ / std::to_string(strip); }

void PointStrips::add(std::span<const double> coordinates)
{
    const auto d = static_cast<std::size_t>(dimension_);
    for (std::size_t i = 0; i + d <= coordinates.size(); i += d) {
        const auto place = static_cast<std::size_t>(coordinates[i + d - 1] * static_cast<double>(count()));
        std::vector<double>& buffer = buffers_[std::min(place, count() - 1)];
        buffer.insert(buffer.end(), &coordinates[i], &coordinates[i] + d);
        if (buffer.size() >= buffered_numbers) write_out(std::min(place, count() - 1));
    }
    points_ += coordinates.size() / d;
}

void PointStrips::write_out(std::size_t strip)
{
    std::vector<double>& buffer = buffers_[strip];
    StripFile file(std::fopen(file_of(strip).c_str(), "ab"), &std::fclose);
    if (!file) fail_at(file_of(strip));
    const bool is_written = std::fwrite(buffer.data(), sizeof(double), buffer.size(), file.get()) == buffer.size();
    if (!is_written || std::fclose(file.release()) != 0) fail_at(file_of(strip));
    buffer.clear();
}

void PointStrips::finish()
{
    for (std::size_t strip = 0; strip < count(); ++strip) {
        write_out(strip);
        buffers_[strip].shrink_to_fit();
    }
}

std::vector<double> PointStrips::read(std::size_t strip) const
{
    std::error_code unknown;
    std::vector<double> numbers(std::filesystem::file_size(file_of(strip), unknown) / sizeof(double));
    const StripFile file(unknown ? nullptr : std::fopen(file_of(strip).c_str(), "rb"), &std::fclose);
    if (!file || std::fread(numbers.data(), sizeof(double), numbers.size(), file.get()) != numbers.size())
        fail_at(file_of(strip));
    return numbers;
}

PointSet PointStrips::strip(std::size_t number) const { return {dimension_, read(number)}; }

void PointStrips::append_around(std::size_t number, double below, double above, bool is_window, PointSet& points) const
{
    const auto d = static_cast<std::size_t>(dimension_);
    const double begin = begin_of(number), end = begin_of(number + 1);
    // Does any image of low ... high lie below or above the strip, near enough?
    const auto is_near = [&](double low, double high) {
        for (const double turn : {0.0, -1.0, 1.0}) {
            if (is_window && turn != 0) break;
            if (low + turn < begin && high + turn >= begin - below) return true;
            if (high + turn >= end && low + turn < end + above) return true;
        }
        return false;
    };
    for (std::size_t other = 0; other < count(); ++other) {
        if (other == number || !is_near(begin_of(other), begin_of(other + 1))) continue;
        const std::vector<double> numbers = read(other);
        for (std::size_t i = 0; i + d <= numbers.size(); i += d)
            if (is_near(numbers[i + d - 1], numbers[i + d - 1]))
                points.coordinates.insert(points.coordinates.end(), &numbers[i], &numbers[i] + d);
    }
}

}
