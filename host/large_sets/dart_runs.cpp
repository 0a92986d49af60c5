#include "host/large_sets/large_darts.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace poissonlab {
namespace {

constexpr std::uint64_t points_per_interval = std::uint64_t{1} << 18;
constexpr std::uint64_t points_per_piece_of_darts = std::uint64_t{1} << 20;

/// A file of a run: the number of points before each interval and of all, then the points.
class RunFile
{
public:
    RunFile(const std::filesystem::path& path, int flags)
        : path_(path), file_(::open(path.c_str(), flags | O_CLOEXEC, 0666))
    {
        if (file_ < 0) fail(errno);
    }
    RunFile(const RunFile&) = delete;
    RunFile& operator=(const RunFile&) = delete;
    ~RunFile()
    {
        if (file_ >= 0) ::close(file_);
    }

    template <typename Value>
    void write(std::span<const Value> values)
    {
        for (auto bytes = std::as_bytes(values); !bytes.empty();) {
            const ssize_t done = ::write(file_, bytes.data(), bytes.size());
            if (done < 0 && errno == EINTR) continue;
            if (done <= 0) fail(errno);
            bytes = bytes.subspan(static_cast<std::size_t>(done));
        }
    }

    template <typename Value>
    void read(std::uint64_t place, std::span<Value> values)
    {
        for (auto bytes = std::as_writable_bytes(values); !bytes.empty();) {
            const ssize_t done = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(place));
            if (done < 0 && errno == EINTR) continue;
            if (done <= 0) fail(done == 0 ? ENODATA : errno);
            place += static_cast<std::uint64_t>(done);
            bytes = bytes.subspan(static_cast<std::size_t>(done));
        }
    }

    /// Throws where the system finds only now that it cannot write.
    void close()
    {
        const int file = file_;
        file_ = -1;
        if (::close(file) != 0) fail(errno);
    }

private:
    [[noreturn]] void fail(int error) const
    {
        throw StorageError(
            fmt::format("{}: points in between cannot be kept: {}", path_.string(), std::strerror(error)));
    }

    std::filesystem::path path_;
    int file_;
};

}

DartIntervals::DartIntervals(std::uint64_t points)
    : bits_(std::min(16u, static_cast<unsigned>(std::bit_width(points / points_per_interval))))
{}

std::size_t DartIntervals::interval_of(std::uint32_t batch, std::uint32_t time) const
{
    if (batch >= most_batches) return count() - 1;
    return (std::size_t{batch} << bits_) + (std::uint64_t{time} >> (32 - bits_));
}

std::vector<std::size_t> dart_pieces(std::span<const std::uint64_t> points_of_intervals)
{
    std::vector<std::size_t> begins{0};
    std::uint64_t points = 0;
    for (std::size_t i = 0; i < points_of_intervals.size(); ++i) {
        if (points > 0 && points + points_of_intervals[i] > points_per_piece_of_darts) {
            begins.push_back(i);
            points = 0;
        }
        points += points_of_intervals[i];
    }
    begins.push_back(points_of_intervals.size());
    return begins;
}

template <int D>
void write_run(const std::filesystem::path& file, std::span<const OrderedDart<D>> darts, const DartIntervals& intervals,
               std::vector<std::uint64_t>& points_of_intervals)
{
    std::vector<std::uint64_t> before(intervals.count() + 1);
    for (const OrderedDart<D>& dart : darts) ++before[intervals.interval_of(dart[0], dart[1]) + 1];
    for (std::size_t i = 0; i < intervals.count(); ++i) {
        points_of_intervals[i] += before[i + 1];
        before[i + 1] += before[i];
    }
    RunFile run(file, O_WRONLY | O_CREAT | O_TRUNC);
    run.write(std::span<const std::uint64_t>(before));
    run.write(darts);
    run.close();
}

template <int D>
void read_run(const std::filesystem::path& file, const DartIntervals& intervals, std::size_t first, std::size_t end,
              std::vector<OrderedDart<D>>& darts)
{
    RunFile run(file, O_RDONLY);
    std::array<std::uint64_t, 1> begin_at{}, end_at{};
    run.read(first * sizeof(std::uint64_t), std::span<std::uint64_t>(begin_at));
    run.read(end * sizeof(std::uint64_t), std::span<std::uint64_t>(end_at));
    const std::size_t before = darts.size();
    darts.resize(before + (end_at[0] - begin_at[0]));
    const std::uint64_t head = (intervals.count() + 1) * sizeof(std::uint64_t);
    run.read(head + begin_at[0] * sizeof(OrderedDart<D>), std::span<OrderedDart<D>>(darts).subspan(before));
}

template void write_run<2>(const std::filesystem::path&, std::span<const OrderedDart<2>>, const DartIntervals&,
                           std::vector<std::uint64_t>&);
template void write_run<3>(const std::filesystem::path&, std::span<const OrderedDart<3>>, const DartIntervals&,
                           std::vector<std::uint64_t>&);
template void read_run<2>(const std::filesystem::path&, const DartIntervals&, std::size_t, std::size_t,
                          std::vector<OrderedDart<2>>&);
template void read_run<3>(const std::filesystem::path&, const DartIntervals&, std::size_t, std::size_t,
                          std::vector<OrderedDart<3>>&);

}
