#include "tests/fuzz/fuzz_support.hpp"

#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

namespace poissonlab::fuzz {
namespace {

constexpr std::size_t longest_message = 1000; ///< beside the place

#ifndef POISSONLAB_FUZZ_COVERAGE
/// Counters that libFuzzer takes for coverage where the program is not instrumented: one for each kind of outcome, so
/// that inputs which lead to other ones are kept and changed further.
__attribute__((section("__libfuzzer_extra_counters"))) std::uint8_t outcome_counters[1 << 12];

void count_outcome(std::string_view outcome)
{
    std::uint32_t hash = 2166136261U; // FNV-1a, of words: numbers and places differ without meaning
    for (const char c : outcome)
        if ((c >= 'a' && c <= 'z') || c == ' ') hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    ++outcome_counters[hash % std::size(outcome_counters)];
}
#else
void count_outcome(std::string_view) {}
#endif

void check_message(std::string_view message, std::string_view place)
{
    if (printable(message) != message) report_finding("a message that is not one line of text", message);
    if (message.size() > place.size() + longest_message) report_finding("a message that is too long", message);
    if (message.find(place) == message.npos) report_finding("a message that does not name its place", message);
    if (message.size() < place.size() + 5) report_finding("a message that says nothing", message);
}

/// Makes a folder, in memory where the system has a place for that.
std::filesystem::path make_folder()
{
    if (std::filesystem::is_directory("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
    static std::optional<TemporaryFolder> folder;
    folder.emplace();
    return folder->path();
}

}

void report_finding(std::string_view what, std::string_view message)
{
    std::fprintf(stderr, "FINDING: %.*s\n%.*s\n", static_cast<int>(what.size()), what.data(),
                 static_cast<int>(message.size()), message.data());
    std::abort();
}

void require(bool is_so, std::string_view what)
{
    if (!is_so) report_finding(what);
}

bool accepts(std::string_view place, const std::function<void()>& read)
{
    try {
        read();
        count_outcome("accepted");
        return true;
    } catch (const InputError& error) {
        check_message(error.what(), place);
        count_outcome(error.what());
        return false;
    } catch (const std::exception& error) {
        report_finding("an exception that is no InputError", error.what());
    }
}

const std::filesystem::path& input_folder()
{
    static const std::filesystem::path folder = make_folder();
    return folder;
}

std::filesystem::path write_input(const std::string& name, std::string_view content)
{
    const std::filesystem::path file = input_folder() / name;
    const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const auto written = handle < 0 ? -1 : ::write(handle, content.data(), content.size());
    if (handle >= 0) ::close(handle);
    if (written != static_cast<ssize_t>(content.size())) {
        std::perror(file.c_str());
        std::_Exit(1); // no finding: the machine has no room
    }
    return file;
}

}
