// How far the work is: one line that updates itself on a terminal, a plain line a series in a pipe.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace poissonlab {

class Progress
{
public:
    enum class Style
    {
        quiet,
        terminal,
        plain
    };

    /// Writes to standard output.
    explicit Progress(Style style);
    ~Progress();

    /// quiet, or what standard output is.
    static Style detect(bool quiet);

    /// Run `number`, counted from 1, of the `count` runs of a collection is next: says so, and keeps saying it.
    void start_run(std::size_t number, std::size_t count, const std::string& title);

    /// `total` realizations of all series are to come; starts the clock.
    void start(std::uint64_t total);

    void start_series(const std::string& label, std::uint32_t realizations);

    /// Another realization is done; `points` and `seconds` of sampling give the rate.
    void realization_done(std::size_t points, double seconds);

    /// The series is done; `line` sums it up.
    void finish_series(const std::string& line);

    /// A step without a count, such as a picture of the report. Terminal only.
    void step(const std::string& what);

    /// All runs are done: what follows is about all of them.
    void finish_runs() { run_.clear(); }

    /// Removes the updating line.
    void finish() { clear(); }

private:
    void print(const std::string& line);
    void update(const std::string& line);
    void clear();

    Style style_;
    std::chrono::steady_clock::time_point begin_;
    std::uint64_t total_ = 0;
    std::uint64_t done_ = 0;
    std::string run_; ///< "[3/34] "; empty: not of a collection
    std::string label_;
    std::uint32_t series_total_ = 0;
    std::uint32_t series_done_ = 0;
    bool line_open_ = false;
};

/// "3.2 s", "2 min 05 s", "1 h 07 min".
std::string duration_text(double seconds);

/// "950 points/s", "1.20 M points/s".
std::string rate_text(double points_per_second);

}
