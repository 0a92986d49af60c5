// The options of commands that make something: which of all results, by what, on which device, and how silently.
#pragma once

#include "app/commands/command.hpp"
#include "base/word_table.hpp"
#include "host/kinds/distribution_place.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The error for a word that an option, or an argument, of a command does not know.
InputError unknown_word(const std::string& command, const std::string& option, const std::string& word,
                        const std::vector<std::string>& known);

/// The value that a word names. Throws unknown_word().
template <class Value, std::size_t N>
Value value_of_word(const std::string& command, const std::string& option, const std::string& word,
                    const WordTable<Value, N>& table)
{
    if (const auto value = table.find(word)) return *value;
    throw unknown_word(command, option, word, table.all());
}

/// --seed, of commands that make one of many results.
Option seed_option(std::uint64_t& seed);
Option seed_option(std::uint32_t& seed);

/// --quiet
Option quiet_option(bool& is_quiet);

/// --json
Option json_option(bool& as_json, const std::string& help = "Print JSON");

class WorkOptions
{
public:
    /// --seed, --engine, --device and --quiet. Their targets are in this object.
    std::vector<Option> options();

    /// The last three, for commands whose seed is another one.
    std::vector<Option> options_without_seed();

    std::uint64_t seed() const { return seed_; }
    bool is_quiet() const { return quiet_; }

    /// Throws InputError, a line that begins with the command, for an unknown word.
    Engine engine(const std::string& command) const;

    /// The engine, a device that is opened when it is needed, and a listener that shows steps, unless all is quiet.
    DistributionPlace place(const std::string& command, bool is_silent = false) const;

private:
    std::uint64_t seed_ = 1;
    std::string engine_ = "opencl";
    std::string device_;
    bool quiet_ = false;
};

/// A file as an argument without an option: a name that begins with a dash is written as "./-name".
std::string file_word(const std::string& file);

/// Returns the comment of a point file: the command with these words, quoted for a shell, that makes the points again,
/// followed by `what` as a shell comment that describes them. Commands that are too long for a line of a comment, or
/// have control characters, are left out: a part of them could not be run.
std::string command_comment(const std::string& command, const std::vector<std::string>& words, std::uint64_t seed,
                            const std::string& what);

/// Joins several lists of options into one.
std::vector<Option> joined(std::vector<std::vector<Option>> lists);

}
