// Progress of the work: a bar that updates itself on a terminal, plain lines in a pipe, or events for scripts.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace poissonlab {

/// The amount of work, in realizations.
struct WorkTotals
{
    std::uint64_t realizations = 0; ///< in all
    std::uint64_t to_make = 0;      ///< that are not stored
    std::uint64_t to_analyse = 0;   ///< whose analysis is not stored
};

class Progress
{
public:
    enum class Style
    {
        quiet,    ///< nothing but what was asked for, such as a path
        terminal, ///< a line that updates itself
        plain,    ///< a line a series, and one now and then while that takes long
        json      ///< one JSON object a line
    };

    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// Writes to standard output. `clock`: for tests.
    explicit Progress(Style style, Clock clock = std::chrono::steady_clock::now);
    ~Progress();

    /// quiet, json, or what standard output is.
    static Style detect(bool quiet, bool json = false);

    /// Work begins; starts the clock.
    void start(const WorkTotals& totals);

    /// A realization was made, of so many points, in so many seconds of sampling.
    void sampled(std::size_t points, double seconds);

    /// A realization was analysed.
    void analysed();

    /// Other processes have made and analysed realizations.
    void elsewhere(std::uint64_t made, std::uint64_t analysed);

    /// A series is done; `line` sums it up.
    void finish_series(const std::string& line);

    /// Run `number`, counted from 1, of the `count` runs of a collection begins.
    void start_run(std::size_t number, std::size_t count, const std::string& title);

    /// A step of long work without a count, such as the parts of a tile set or the pictures of the report.
    void step(const std::string& what);

    /// Something that the user must know.
    void message(const std::string& text);

    /// Something that the user should know of an input or a result; a line that begins as all notes do.
    void note(const std::string& text);

    /// Removes the updating line.
    void finish() { clear(); }

    /// All is done: the path of the report. Said in every style.
    void report(const std::string& path);

private:
    /// The time that one sort of work takes. The first count also has the time of what happens once, such as building
    /// kernels and planning transforms; it is left out as soon as there are others.
    struct Pace
    {
        void add(double time, std::uint64_t more);
        double seconds_each() const; ///< 0: nothing is done yet

        /// Seconds that are left where there are `total`; nothing while one is done at most, and work is left.
        std::optional<double> seconds_left(std::uint64_t total) const;

        double seconds = 0;
        std::uint64_t count = 0;
        double first_seconds = 0;
        std::uint64_t first_count = 0;
    };

    void advance(std::uint64_t made, std::uint64_t analysed, double most_seconds);
    std::string state() const;
    void show_state();
    void print(const std::string& line);
    void update(const std::string& line);
    void clear();
    bool is_time(double seconds);
    double elapsed() const;
    std::optional<double> seconds_left() const;

    Style style_;
    Clock clock_;
    std::chrono::steady_clock::time_point begin_;
    std::chrono::steady_clock::time_point said_; ///< when something was last said without need
    WorkTotals totals_;
    std::chrono::steady_clock::time_point advanced_; ///< when a realization was last made or analysed
    Pace made_;
    Pace analysed_;
    double points_per_second_ = 0; ///< of the last realization made here
    bool line_open_ = false;
};

/// "3.2 s", "2 min 05 s", "1 h 07 min".
std::string duration_text(double seconds);

/// "950 points/s", "1.20 M points/s".
std::string rate_text(double points_per_second);

}
