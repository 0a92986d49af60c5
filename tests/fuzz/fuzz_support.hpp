// The rule that every fuzz target holds the program to: any input is either accepted, or refused with an InputError
// that a person can read. Whatever else comes out (other exceptions, crashes, what sanitizers see, hours, gigabytes) is
// a finding.
#pragma once

#include "base/errors/errors.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace poissonlab::fuzz {

/// Ends the program, and so makes a finding, with a line that says what was not as it must be.
[[noreturn]] void report_finding(std::string_view what, std::string_view message = {});

/// A finding unless `is_so`.
void require(bool is_so, std::string_view what);

/// Runs what reads an input. Returns whether the input was accepted. A message must be one line that can be shown, of
/// bearable length, and name `place`: a file, or "" for what has no place of its own.
bool accepts(std::string_view place, const std::function<void()>& read);

/// A folder in memory, of this process alone, that is gone with it.
const std::filesystem::path& input_folder();

/// Writes a file of that folder anew, without the care that write_whole_file() takes.
std::filesystem::path write_input(const std::string& name, std::string_view content);

}

/// LibFuzzer calls this with each input. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);
