// The options of commands that do the work of a kind: its keys, and what all such commands have.
#pragma once

#include "app/commands/output_file.hpp"
#include "app/commands/work_options.hpp"
#include "host/kinds/kind.hpp"
#include "results/pictures/distribution_result.hpp"

#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// The files that a command writes: --out, as often as one likes.
struct OutputFiles
{
    OutputFormats formats;
    std::vector<std::string> names{}; ///< that were typed

    Option option();

    /// Throws where one of them cannot be written: checked_output().
    void check(const std::string& command) const;

    /// The files that the command writes.
    std::vector<std::filesystem::path> files() const;
};

class KindOptions
{
public:
    /// `kind` must outlive it. The key `placed`, if there is one, is an argument known by its place, not an option.
    explicit KindOptions(const Kind& kind, std::string placed = "")
        : KindOptions(kind, OutputFiles{}, std::move(placed))
    {}

    /// Takes the options of a command that writes files as well.
    KindOptions(const Kind& kind, OutputFiles files, std::string placed = "");

    /// An option for each key, in the order of the kind, and --seed, --engine, --device, --quiet, --json. Their targets
    /// are in this object.
    std::vector<Option> options();

    /// The typed settings, checked as a table of a config is. Throws InputError, a line that begins with the command.
    KindSettings settings() const;

    /// Returns the typed settings in the kind's own type, once the files that are to be written are checked as well.
    template <class Settings>
    Settings read() const
    {
        const KindSettings typed = settings();
        outs.check(command());
        return typed.as<Settings>();
    }

    const Kind& kind() const { return kind_; }
    const std::string& command() const { return kind_.command; }
    std::uint64_t seed() const { return work_.seed(); }
    bool is_quiet() const { return work_.is_quiet(); }

    /// Standard output is one JSON object and nothing else.
    bool prints_json() const { return as_json_; }

    /// The engine, a device that is opened when it is needed, and a listener that shows steps, unless JSON is printed.
    DistributionPlace place(bool is_silent = false) const { return work_.place(command(), as_json_ || is_silent); }

    /// Says what a person should know of an input, unless nothing is to be said.
    void say_note(const std::string& note) const;

    /// Says what was written to --out, and in what time, unless nothing is to be said or the points go to standard
    /// output.
    void say_written(const std::string& what) const;

    /// Returns the command that makes the points again, for a comment in their file, followed by `what` they are, as
    /// a comment of the shell. Options that change no point are left out.
    std::string command_comment(const std::string& what) const;

    /// Returns the error with the command's name before its message, unless it names the command or a place in a file.
    InputError of_command(const InputError& error) const;

    OutputFiles outs;          ///< --out, of commands that list it
    std::filesystem::path out; ///< --out, of commands that write one file
    std::uint32_t pixels = 0;  ///< --pixels, the width of a .png; 0: by default

private:
    /// The words that were typed for a key.
    struct Typed
    {
        KeySpec spec;
        std::string name;               ///< of the option
        std::vector<std::string> words; ///< empty: nothing
        bool is_set = false;            ///< of a flag
    };

    Option option_of(Typed& typed) const;
    ConfigNode node_of(const Typed& typed) const;

    const Kind& kind_;
    std::string placed_;
    std::deque<Typed> typed_;
    WorkOptions work_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    bool as_json_ = false;
};

/// Prints numbers as one JSON object: each by its key, as results.json calls it, and in "meanings" what it is, with
/// its unit.
void print_numbers(const std::vector<DistributionNumber>& numbers);

/// The width of a .png: --pixels.
struct PictureWidth
{
    std::uint32_t most = 0;  ///< 0: there is no such option
    std::string otherwise;   ///< what the help says of the default
    std::uint32_t usual = 0; ///< the default, of KindOptions::pixels
};

/// A command that makes what is no kind of work, but takes keys as kinds do.
template <class Settings>
Kind described_command(std::string command, std::string summary, void (*keys)(Keys&, Settings&))
{
    const auto visit = [keys](Keys& visited) {
        Settings settings;
        keys(visited, settings);
        return KindSettings{std::move(settings), {}, visited.resolved(), visited.inputs()};
    };
    return {{"", "", std::move(command), "", std::move(summary)}, visit, {}};
}

/// The command of a kind. `others` are its options beside those of the kind, `work` does what it does.
template <class Options>
Command kind_command(const std::shared_ptr<Options>& options, std::vector<Option> others, std::string notes,
                     void (*work)(const Options&))
{
    const std::string& name = options->kind().command;
    return {name.substr(name.find(' ') + 1), options->kind().summary, joined({options->options(), std::move(others)}),
            std::move(notes), [options, work] {
                try {
                    work(*options);
                } catch (const InputError& error) {
                    throw options->of_command(error);
                }
                return 0;
            }};
}

/// The command of a kind that writes files where --out says, as often as one likes.
Command kind_command(const Kind& kind, OutputFiles files, std::string notes, void (*work)(const KindOptions&),
                     std::string placed = "", const PictureWidth& width = {});

}
