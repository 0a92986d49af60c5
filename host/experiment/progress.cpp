#include "experiment/progress.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

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

}

Progress::Progress(Style style) : style_(style), begin_(std::chrono::steady_clock::now()) {}

Progress::~Progress() { clear(); }

Progress::Style Progress::detect(bool quiet)
{
    if (quiet) return Style::quiet;
    return isatty(STDOUT_FILENO) ? Style::terminal : Style::plain;
}

void Progress::start_run(std::size_t number, std::size_t count, const std::string& title)
{
    run_ = fmt::format("[{}/{}] ", number, count);
    print(run_ + title);
}

void Progress::start(std::uint64_t total)
{
    total_ = total;
    done_ = 0;
    begin_ = std::chrono::steady_clock::now();
}

void Progress::start_series(const std::string& label, std::uint32_t realizations)
{
    label_ = label;
    series_total_ = realizations;
    series_done_ = 0;
    update(fmt::format("{}: realization 1/{}", label_, series_total_));
}

void Progress::realization_done(std::size_t points, double seconds)
{
    ++done_;
    ++series_done_;
    if (style_ != Style::terminal) return;
    // Realizations still to come are taken to be as slow as those done.
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double left = elapsed / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string rate = seconds > 0 ? rate_text(static_cast<double>(points) / seconds) + ", " : "";
    update(fmt::format("{}: realization {}/{}, {}{} left", label_, std::min(series_done_ + 1, series_total_),
                       series_total_, rate, duration_text(left)));
}

void Progress::finish_series(const std::string& line) { print(line); }

void Progress::print(const std::string& line)
{
    if (style_ == Style::quiet) return;
    clear();
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

void Progress::step(const std::string& what) { update(what); }

void Progress::update(const std::string& line)
{
    if (style_ != Style::terminal) return;
    fmt::print("\r\033[K{}", first_columns(run_ + line, terminal_columns()));
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
