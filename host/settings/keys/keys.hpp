// The keys of a kind of work, each named once: a function that visits them describes and reads them alike, so that TOML
// tables, options of commands, Python, help and documentation follow from the same line.
//
//     void stipple_keys(Keys& keys, StippleSettings& s)
//     {
//         keys.number("ink", s.ink, {0.001, 1}, "the part of the ink that is printed");
//     }
//
// The member's own value is the default. Without a table the function describes the keys and changes nothing; with one
// it reads those that the table has.
#pragma once

#include "base/word_table.hpp"
#include "host/sampling/parameters.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/keys/choices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// A key as it was described.
struct KeySpec
{
    ParameterSpec value;              ///< of a list: of each number in it
    std::size_t count = 1;            ///< numbers of a list
    std::vector<std::string> parts{}; ///< of a list: what its numbers are
    bool is_spread = false;           ///< a number, or how it is spread over many things
    bool is_file = false;             ///< a text that may name a file
    bool is_formula = false;          ///< or be a formula
    bool is_region = false;           ///< or describe a region
    bool is_required = false;
    std::string excludes{}; ///< the key that does not go together with this one
    std::string alias{};    ///< what commands and Python call it; empty: as configs do
    std::string own{};      ///< of a value of its own: what is allowed
    std::size_t fewest = 0; ///< numbers that a list may have; 0: as many as `count`

    /// The values that the key may have, in the words of messages and documentation.
    std::string allowed() const;
};

/// The option of commands that gives a key: --image-from for image_from.
std::string option_name(const std::string& key);

/// The option of commands that gives a key, by the name that the key has there.
std::string option_name(const KeySpec& spec);

/// The help of a key: what it means, what is allowed, and the default.
std::string key_help(const KeySpec& spec);

/// The largest integer of a config: a range up to it is none.
inline constexpr std::int64_t any_integer = std::numeric_limits<std::int64_t>::max();

/// Ends of what a number may be; both are allowed.
struct Interval
{
    double low = 0;
    double high = 0;
};

class Keys
{
public:
    /// The last key, of which more can be said.
    class Said
    {
    public:
        Said(Keys& keys, std::size_t index) : keys_(keys), index_(index) {}
        Said unit(std::string words);
        Said excludes(const std::string& other); ///< throws InputError where a table has both
        Said required();                         ///< throws InputError where a table lacks it
        Said otherwise(std::string words);       ///< what holds without it, where no value can say it
        Said called(std::string words);          ///< by commands and Python
        Said at_most(std::size_t count);         ///< numbers of a list, whose number depends on other keys

        /// Throws InputError where a table has it although it does not apply; `when` says when it would: "show =
        /// tiling".
        Said only_if(bool applies, const std::string& when);

    private:
        Keys& keys_;
        std::size_t index_;
    };

    /// Describes.
    Keys() = default;

    /// Reads `table`, which is called `name` in messages ("[[distribution]]", or nothing where the place says it) and
    /// stands at `where`: names of files count from the folder of that file. The options of a command are a table as
    /// well, at an argument: its name is the command's.
    Keys(const ConfigTable& table, SourceLocation where, std::string name);

    Said number(const std::string& key, double& value, Interval range, std::string help);
    Said number(const std::string& key, std::optional<double>& value, Interval range, std::string help);
    template <class Integer>
    Said integer(const std::string& key, Integer& value, std::int64_t low, std::int64_t high, std::string help);
    template <class Integer>
    Said integer(const std::string& key, std::optional<Integer>& value, std::int64_t low, std::int64_t high,
                 std::string help);
    Said flag(const std::string& key, bool& value, std::string help);
    /// True, false or "auto", which is nothing and what holds without it.
    Said flag(const std::string& key, std::optional<bool>& value, std::string help);
    Said text(const std::string& key, std::string& value, std::string help);

    /// One of these words.
    Said word(const std::string& key, std::string& value, std::vector<std::string> words, std::string help);
    template <class Enum, std::size_t N>
    Said word(const std::string& key, Enum& value, const WordTable<Enum, N>& words, std::string help);

    /// Numbers in a list; `parts` are words for each, as many as there are, `ranges` one for all, or one each.
    template <std::size_t N>
    Said numbers(const std::string& key, std::array<double, N>& values, std::vector<Interval> ranges,
                 std::vector<std::string> parts, std::string help);

    template <std::size_t N>
    Said integers(const std::string& key, std::array<std::uint32_t, N>& values, Interval range,
                  std::vector<std::string> parts, std::string help);

    /// Takes as many integers of any size as there are `parts`, or at least `fewest`; a value that is not given stays
    /// empty.
    Said whole_numbers(const std::string& key, std::vector<std::int64_t>& values, std::int64_t low,
                       std::vector<std::string> parts, std::string help, std::size_t fewest = 0);

    /// Some of these words, in a list.
    Said words(const std::string& key, std::vector<std::string>& values, std::vector<std::string> known,
               std::string help);

    /// A parameter as a sampler describes it.
    Said parameter(ParameterSpec spec, Parameters& values);

    /// A value that `read` takes apart, which throws what refused() makes; `allowed` says what it may be.
    Said value(const std::string& key, std::string allowed, std::string help,
               const std::function<void(const ConfigNode& node)>& read);

    /// A number of each thing: a number, { uniform = [a, b] } or { normal = [mean, deviation] }.
    Said spread(const std::string& key, SpreadChoice& value, Interval range, std::string help);

    /// A file that has to be there: `what` it must be.
    Said file(const std::string& key, std::filesystem::path& value, std::string help,
              const std::string& what = "a file");
    /// A picture's file: what is none is refused before any work, by its header.
    Said picture(const std::string& key, std::filesystem::path& value, std::string help);

    /// Texts in a list, as many as `spec` says at most, which are files or may be where it says so. A single one needs
    /// no list. `allowed` is what messages call the value.
    Said texts(KeySpec spec, std::vector<std::string>& values, const std::string& allowed);

    /// Files of pictures, in a list: options of commands are given once for each, and a single one needs no list.
    Said pictures(const std::string& key, std::vector<std::filesystem::path>& values, std::string help);

    /// The key `region`, which is required: a region's file, or what describes one, see read_region().
    Said region(std::string& value);
    /// A key of the same manner that may be left out.
    Said region(const std::string& key, std::string& value, std::string help);

    /// A picture's file, or a formula, and the key `KEY_from`, which says what of the picture is meant.
    Said picture_or_formula(const std::string& key, std::string& value, std::string help);
    Said picture_or_formula(const std::string& key, std::string& value, std::string& from, std::string help);

    /// A number, or what it is over a region: a picture's file or a formula, with the key `KEY_from`.
    Said number_over_region(const std::string& key, std::optional<double>& value, std::string& text, std::string& from,
                            Interval range, std::string help);

    /// The key `points`, which is required.
    Said points(std::size_t& value, std::string help = "the number of points");

    /// The keys `density`, which is required, and `density_from`: what points follow, over a square where it is a
    /// formula.
    void density(DensityChoice& value);

    /// The key `tiles`: a tile set's file.
    Said tiles(std::filesystem::path& value);

    /// The keys `tiles` and `method`: what makes even points.
    void even_points(EvenMethodChoice& value);

    // These concern a table that is read. Errors name keys as their door does: `dot` in a config, `--dot` in a command.
    bool is_read() const { return table_ != nullptr; }
    bool is_given(const std::string& key) const;
    const SourceLocation& place_of(const std::string& key) const; ///< of a key that is given
    std::string name_of(const std::string& key) const;
    std::string shown(const std::string& key, const std::string& word) const;     ///< `by = "ranks"`, or `--by ranks`
    InputError invalid(const std::string& key, const std::string& allowed) const; ///< of a key that is given
    InputError problem(const std::string& what) const;                            ///< of the whole table

    /// Does what may throw InputError because of the value of a key, and says so.
    void check(const std::string& key, const std::function<void()>& work) const;

    /// Does what may throw InputError that names a key itself: it is said at that key, where it is given.
    void check(const std::function<void()>& work) const;

    const std::vector<KeySpec>& described() const { return specs_; }

    /// Keys and values that were described or read, in one line: what decides the result, but for what files hold.
    const std::string& resolved() const { return resolved_; }

    /// Files that values name, whose contents decide the result as well.
    const std::vector<std::filesystem::path>& inputs() const { return inputs_; }

    /// Adds a file that one of these names in turn.
    void reads_too(std::filesystem::path file) { inputs_.push_back(std::move(file)); }

private:
    Said describe(KeySpec spec);
    const ConfigNode* given(const std::string& key) const;
    void resolve(const std::string& key, const std::string& value);
    void from_of_picture(const std::string& key, const std::string& value, std::string& from);
    Said list(std::vector<double>& values, KeySpec spec, const std::vector<Interval>& ranges);
    std::optional<ParameterValue> read(const ParameterSpec& spec) const;
    void check_text(const std::string& key, const std::string& text) const;
    std::string path_of(const std::string& key, const std::string& text) const;
    std::string named_file(const std::string& key, const std::string& text);

    const ConfigTable* table_ = nullptr;
    SourceLocation where_;
    std::string name_;
    std::vector<KeySpec> specs_;
    std::string resolved_;
    std::vector<std::filesystem::path> inputs_;
};

/// Refuses keys of a table that are neither described by `visit` nor in `before` and `after`, which messages list as
/// well. This is checked before the table is read, so that a mistyped key is reported as such and not as a missing one.
void check_described_keys(const ConfigTable& table, const std::function<void(Keys&)>& visit,
                          std::vector<std::string> before = {}, const std::vector<std::string>& after = {});

/// The name of a file without its folders, or a formula, shortened: for labels.
std::string name_of_input(const std::string& text);

template <class Integer>
Keys::Said Keys::integer(const std::string& key, Integer& value, std::int64_t low, std::int64_t high, std::string help)
{
    std::optional<Integer> kept = value;
    const Said said = integer(key, kept, low, high, std::move(help));
    specs_.back().value.otherwise = static_cast<std::int64_t>(value);
    value = *kept;
    return said;
}

template <class Integer>
Keys::Said Keys::integer(const std::string& key, std::optional<Integer>& value, std::int64_t low, std::int64_t high,
                         std::string help)
{
    KeySpec spec{.value = {.key = key,
                           .kind = ParameterSpec::Kind::integer,
                           .help = std::move(help),
                           .minimum = static_cast<double>(low),
                           .maximum = static_cast<double>(high)}};
    if (const auto read_value = read(spec.value)) value = static_cast<Integer>(std::get<std::int64_t>(*read_value));
    resolve(key, value ? std::to_string(*value) : "none");
    return describe(std::move(spec));
}

template <class Enum, std::size_t N>
Keys::Said Keys::word(const std::string& key, Enum& value, const WordTable<Enum, N>& words, std::string help)
{
    std::string chosen = words[value];
    const Said said = word(key, chosen, words.all(value), std::move(help));
    value = *words.find(chosen);
    return said;
}

template <std::size_t N>
Keys::Said Keys::numbers(const std::string& key, std::array<double, N>& values, std::vector<Interval> ranges,
                         std::vector<std::string> parts, std::string help)
{
    std::vector<double> all(values.begin(), values.end());
    KeySpec spec{.value = {.key = key, .help = std::move(help)}, .count = N, .parts = std::move(parts)};
    const Said said = list(all, std::move(spec), ranges);
    std::copy(all.begin(), all.end(), values.begin());
    return said;
}

template <std::size_t N>
Keys::Said Keys::integers(const std::string& key, std::array<std::uint32_t, N>& values, Interval range,
                          std::vector<std::string> parts, std::string help)
{
    std::vector<double> all(values.begin(), values.end());
    KeySpec spec{.value = {.key = key, .kind = ParameterSpec::Kind::integer, .help = std::move(help)},
                 .count = N,
                 .parts = std::move(parts)};
    const Said said = list(all, std::move(spec), {range});
    std::transform(all.begin(), all.end(), values.begin(),
                   [](double value) { return static_cast<std::uint32_t>(value); });
    return said;
}

}
