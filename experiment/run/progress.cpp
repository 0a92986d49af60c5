#include "experiment/run/progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace poissonlab {
namespace {

/// The first `columns` characters of UTF-8 text.
std::string first_columns(const std::string& text, std::size_t columns)
{
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size(); ++end) {
        const bool starts_character = (static_cast<unsigned char>(text[end]) & 0xC0U) != 0x80U;
        if (starts_character && count++ == columns) break;
    }
    return text.substr(0, end);
}

std::size_t terminal_columns()
{
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) return size.ws_col - 1U;
    return 79;
}

constexpr double seconds_between_lines = 10;
constexpr double seconds_between_bars = 0.1;
constexpr double seconds_between_events = 1;

void print_event(const nlohmann::ordered_json& event)
{
    // Labels and paths can hold any bytes; JSON is UTF-8.
    fmt::print("{}\n", event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    std::fflush(stdout);
}

}

Progress::Progress(Style style, Clock clock) : style_(style), clock_(std::move(clock)), begin_(clock_()), said_(begin_)
{}

Progress::~Progress() { clear(); }

Progress::Style Progress::detect(bool quiet, bool json)
{
    if (json) return Style::json;
    if (quiet) return Style::quiet;
    return isatty(STDOUT_FILENO) ? Style::terminal : Style::plain;
}

void Progress::start(const WorkTotals& totals)
{
    totals_ = totals;
    made_ = analysed_ = {};
    begin_ = said_ = advanced_ = clock_();
    const std::uint64_t stored = totals.realizations - totals.to_make;
    if (style_ == Style::json)
        print_event({{"event", "start"}, {"realizations", totals.realizations}, {"stored", stored}});
    else if (stored > 0)
        print(fmt::format("{} of {} realizations are there already", stored, totals.realizations));
}

double Progress::elapsed() const { return std::chrono::duration<double>(clock_() - begin_).count(); }

void Progress::Pace::add(double time, std::uint64_t more)
{
    if (count == 0) {
        first_seconds = time;
        first_count = more;
    }
    seconds += time;
    count += more;
}

double Progress::Pace::seconds_each() const
{
    if (count == 0) return 0;
    if (count == first_count) return seconds / static_cast<double>(count);
    return (seconds - first_seconds) / static_cast<double>(count - first_count);
}

std::optional<double> Progress::Pace::seconds_left(std::uint64_t total) const
{
    if (total == count) return 0;
    if (count < 2) return std::nullopt;
    return seconds_each() * static_cast<double>(total - count);
}

/// Seconds left, if each remaining realization takes as long to make and to analyse as those that are done. Nothing
/// while one of the two times is not known, and after the last realization: how long what belongs to a series as a
/// whole will take is not known then.
std::optional<double> Progress::seconds_left() const
{
    const auto make = made_.seconds_left(totals_.to_make), analyse = analysed_.seconds_left(totals_.to_analyse);
    if (!make || !analyse || *make + *analyse == 0) return std::nullopt;
    return *make + *analyse;
}

/// "52/120 realizations, 1.20 M points/s, 2 min 05 s left"
std::string Progress::state() const
{
    const std::uint64_t stored = totals_.realizations - totals_.to_make;
    const std::string rate = points_per_second_ > 0 ? ", " + rate_text(points_per_second_) : "";
    const auto seconds = seconds_left();
    return fmt::format("{}/{} realizations{}{}", stored + made_.count, totals_.realizations, rate,
                       seconds ? ", " + duration_text(*seconds) + " left" : "");
}

void Progress::sampled(std::size_t points, double seconds)
{
    points_per_second_ = seconds > 0 ? static_cast<double>(points) / seconds : 0;
    // Building what the first realization needs takes time that the others do not.
    advance(1, 0, made_.count == 0 ? seconds : elapsed());
}

void Progress::analysed() { advance(0, 1, elapsed()); }

void Progress::elsewhere(std::uint64_t made, std::uint64_t analysed) { advance(made, analysed, elapsed()); }

/// Adds what is done since the last call, and the time that it took: at most `most_seconds` of the time since then.
void Progress::advance(std::uint64_t made, std::uint64_t analysed, double most_seconds)
{
    if (made + analysed == 0) return;
    const auto now = clock_();
    const double since = std::chrono::duration<double>(now - std::exchange(advanced_, now)).count();
    made = std::min(made, totals_.to_make - made_.count);
    analysed = std::min(analysed, totals_.to_analyse - analysed_.count);
    if (made + analysed > 0) {
        const double each = std::min(since, most_seconds) / static_cast<double>(made + analysed);
        if (made > 0) made_.add(each * static_cast<double>(made), made);
        if (analysed > 0) analysed_.add(each * static_cast<double>(analysed), analysed);
    }
    show_state();
}

void Progress::show_state()
{
    if (style_ == Style::terminal && (is_time(seconds_between_bars) || !line_open_)) {
        constexpr int width = 24;
        const std::uint64_t all = std::max<std::uint64_t>(totals_.to_make + totals_.to_analyse, 1);
        const int filled = static_cast<int>(width * (made_.count + analysed_.count) / all);
        update(fmt::format("[{:#<{}}{:-<{}}] {}", "", filled, "", width - filled, state()));
    } else if (style_ == Style::plain && is_time(seconds_between_lines)) {
        print(state());
    } else if (style_ == Style::json && is_time(seconds_between_events)) {
        const auto seconds = seconds_left();
        print_event({{"event", "progress"},
                     {"realizations", totals_.realizations},
                     {"made", totals_.realizations - totals_.to_make + made_.count},
                     {"analysed", totals_.realizations - totals_.to_analyse + analysed_.count},
                     {"points_per_second", points_per_second_},
                     {"seconds_left", seconds ? nlohmann::ordered_json(*seconds) : nlohmann::ordered_json()}});
    }
}

/// True if nothing was written for so long.
bool Progress::is_time(double seconds)
{
    const auto now = clock_();
    if (std::chrono::duration<double>(now - said_).count() < seconds) return false;
    said_ = now;
    return true;
}

void Progress::finish_series(const std::string& line)
{
    if (style_ == Style::json)
        print_event({{"event", "series"}, {"text", line}, {"seconds", elapsed()}});
    else
        print(line);
}

void Progress::start_run(std::size_t number, std::size_t count, const std::string& title)
{
    if (style_ == Style::json)
        print_event({{"event", "run"}, {"number", number}, {"count", count}, {"title", title}, {"seconds", elapsed()}});
    else
        print(fmt::format("[{}/{}] {}", number, count, title));
}

void Progress::step(const std::string& what)
{
    if (style_ == Style::terminal)
        update(what);
    else if (style_ == Style::plain && is_time(seconds_between_lines))
        print(what);
    else if (style_ == Style::json && is_time(seconds_between_events))
        print_event({{"event", "step"}, {"text", what}});
}

void Progress::message(const std::string& text)
{
    if (style_ == Style::json)
        print_event({{"event", "message"}, {"text", text}});
    else
        print(text);
}

void Progress::note(const std::string& text) { message(style_ == Style::json ? text : "poissonlab: note: " + text); }

void Progress::report(const std::string& path)
{
    clear();
    if (style_ == Style::json)
        print_event({{"event", "report"}, {"path", path}, {"seconds", elapsed()}});
    else
        fmt::print("{}\n", path);
}

void Progress::print(const std::string& line)
{
    if (style_ == Style::quiet) return;
    clear();
    fmt::print("{}\n", line);
    std::fflush(stdout);
    said_ = clock_();
}

void Progress::update(const std::string& line)
{
    if (style_ != Style::terminal) return;
    fmt::print("\r\033[K{}", first_columns(line, terminal_columns()));
    std::fflush(stdout);
    line_open_ = true;
}

void Progress::clear()
{
    if (!line_open_) return;
    // fputs and not fmt::print, which may throw: this runs in the destructor.
    std::fputs("\r\033[K", stdout);
    std::fflush(stdout);
    line_open_ = false;
}

std::string duration_text(double seconds)
{
    if (seconds < 60) return fmt::format("{:.1f} s", seconds);
    const auto whole = static_cast<long long>(seconds + 0.5);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string rate_text(double points_per_second)
{
    if (points_per_second < 1e3) return fmt::format("{:.0f} points/s", points_per_second);
    if (points_per_second < 1e6) return fmt::format("{:.0f} k points/s", points_per_second / 1e3);
    return fmt::format("{:.2f} M points/s", points_per_second / 1e6);
}

}
