#include "host/sampling/classics/command_sampler.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/program_run.hpp"
#include "base/programs/shell_words.hpp"
#include "base/random/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <optional>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

constexpr const char* command_key = "command";
constexpr const char* limit_key = "time_limit";
constexpr const char* needs_key = "needs";
constexpr std::size_t lines_shown = 8; ///< of what a program said

constexpr const char* known_fields = "{points}, {dimension}, {seed}, {realization} and {out}";

/// The length of the word in braces that `text` begins with, "{word}"; 0: it does not.
std::size_t field_length(std::string_view text)
{
    if (text.empty() || text[0] != '{') return 0;
    std::size_t end = 1;
    while (end < text.size() && (std::islower(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
    return end > 1 && end < text.size() && text[end] == '}' ? end + 1 : 0;
}

std::string value_of(std::string_view field, const CommandValues& values)
{
    if (field == "{points}") return fmt::format("{}", values.points);
    if (field == "{dimension}") return fmt::format("{}", values.dimension);
    if (field == "{seed}") return fmt::format("{}", values.seed);
    if (field == "{realization}") return fmt::format("{}", values.realization);
    if (field == "{out}") return values.out;
    const std::string shown = shortened(field);
    throw InputError(fmt::format("{} is none of {}; {{{}}} stands for itself", shown, known_fields, shown));
}

/// A word with its fields replaced; `has_out` becomes true where {out} is one of them.
std::string replaced(std::string_view word, const CommandValues& values, bool& has_out)
{
    std::string result;
    while (!word.empty()) {
        const std::size_t escaped = word[0] == '{' ? field_length(word.substr(1)) : 0;
        const std::size_t length = field_length(word);
        if (escaped > 0 && word.size() > escaped + 1 && word[escaped + 1] == '}') {
            result += word.substr(1, escaped);
            word.remove_prefix(escaped + 2);
        } else if (length > 0) {
            result += value_of(word.substr(0, length), values);
            has_out = has_out || word.starts_with("{out}");
            word.remove_prefix(length);
        } else {
            result += word[0];
            word.remove_prefix(1);
        }
    }
    return result;
}

/// The folder that a command runs in: that of the config.
fs::path folder_of(const Parameters& parameters)
{
    return fs::absolute(parameters.location(command_key).file).parent_path();
}

/// A folder that goes with all that is in it.
class OutputFolder
{
public:
    /// The path for {out}, to which programs may add an extension.
    std::string out() const { return (folder_.path() / "points").string(); }

    /// The one file that is there. Throws InputError.
    fs::path file() const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder_.path())) files.push_back(entry.path());
        if (files.empty()) throw InputError("it wrote no file at the path that it was given in place of {out}");
        if (files.size() > 1) {
            std::ranges::sort(files);
            throw InputError(fmt::format("it wrote {} files, {} and {} among them; one is needed", files.size(),
                                         files[0].filename().string(), files[1].filename().string()));
        }
        return files.front();
    }

    /// The one point set of the file: in the unit square (cube), or in a region, in its units. Throws InputError,
    /// which names the file without its folder, which is temporary.
    PointSet read(const FramedRegion* region) const
    {
        const fs::path written = file();
        const std::string name = "its file " + written.filename().string();
        try {
            std::vector<PointSet> sets = region ? read_points(written, any_coordinates) : read_points(written);
            if (sets.size() != 1) throw InputError(fmt::format("it wrote {} realizations; one is needed", sets.size()));
            if (region) region->framed(sets.front(), name); // throws where some are outside
            return std::move(sets.front());
        } catch (const InputError& error) {
            if (error.place().file.empty()) throw;
            throw error.moved_to({name, error.place().line});
        }
    }

private:
    ScratchFolder folder_;
};

/// The last lines that a program said, each on a line of its own.
std::string said(const std::string& output)
{
    std::string text = output;
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    if (text.empty()) return "";
    std::size_t begin = text.size();
    for (std::size_t lines = 0; lines < lines_shown && begin != std::string::npos && begin > 0; ++lines)
        begin = text.rfind('\n', begin - 1);
    if (begin != std::string::npos && begin > 0 && begin < text.size()) text.erase(0, begin + 1);
    // A program's colours and cursor movements are not for this terminal.
    std::string result = "; it said:\n    ";
    for (const char c : text) {
        const bool harmless = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
        result += c == '\n' ? std::string("\n    ") : harmless || c == '\t' ? std::string(1, c) : std::string("?");
    }
    return result;
}

std::string failure_of(const ProgramOutcome& outcome, double limit)
{
    if (!outcome.is_in_time) return fmt::format("it did not end within time_limit = {} seconds", limit);
    if (outcome.signal != 0) return fmt::format("a signal ended it: {}", ::strsignal(outcome.signal));
    return fmt::format("it ended with exit status {}", outcome.status);
}

class CommandSampler final : public Sampler
{
public:
    CommandSampler(const Parameters& parameters, const SampleRequest& request)
        : parameters_(parameters), request_(request), limit_(parameters.number(limit_key))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const OutputFolder folder;
        const auto words = command_words(
            parameters_.text(command_key),
            {request_.points, request_.dimension, command_seed(request_.seed, realization), realization, folder.out()});
        ProgramOutcome outcome;
        try {
            outcome = run_program(words, folder_of(parameters_), limit_, stop_if_interrupted);
            if (!outcome.succeeded()) throw InputError(failure_of(outcome, limit_));
            PointSet points = folder.read(request_.region.get());
            if (points.dimension != request_.dimension)
                throw InputError(fmt::format("it wrote {}D points; the experiment has dimension = {}", points.dimension,
                                             request_.dimension));
            return points;
        } catch (const InputError& error) {
            const InputError what =
                parameters_.error(command_key, fmt::format("realization {}: {}", realization, error.what()));
            throw InputError(what.what(), said(outcome.output));
        }
    }

    // The program decides how many points there are.
    SetTraits traits() const override { return {.sizes_vary = true}; }

private:
    Parameters parameters_;
    SampleRequest request_;
    double limit_;
};

/// Appends the size and the bytes of a file, which may be larger than memory. What cannot be read counts as empty.
void add_content(Xxh64& hash, const fs::path& file)
{
    std::error_code error;
    hash.add(fmt::format("{} ", fs::file_size(file, error)));
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> chunk(1 << 20);
    while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || stream.gcount() > 0)
        hash.add({chunk.data(), static_cast<std::size_t>(stream.gcount())});
}

/// A hash of the program and of all files that the command names: a script that was changed makes other points. What
/// these read themselves is not seen, but that it may lie in the folder that the command runs in, which counts as well.
std::uint64_t program_hash(const Parameters& parameters)
{
    const fs::path folder = folder_of(parameters);
    const std::vector<std::string> words = command_words(parameters.text(command_key), {});
    std::vector<fs::path> files;
    if (const auto program = find_program(words[0], folder)) files.push_back(*program);
    for (std::size_t i = 1; i < words.size(); ++i) files.push_back(folder / words[i]);
    Xxh64 hash;
    hash.add(folder.lexically_normal().string());
    for (const fs::path& file : files) {
        std::error_code error;
        if (fs::is_regular_file(file, error)) add_content(hash, file);
    }
    return hash.value();
}

/// "there is no program x in the folders of PATH"; empty: it is there.
std::string missing_program(const std::string& program, const fs::path& folder)
{
    if (find_program(program, folder)) return {};
    return fmt::format("there is no program {}{}", program,
                       program.find('/') != std::string::npos ? " (paths are relative to the folder of the config)"
                                                              : " in the folders of PATH");
}

/// The words of the command that finds out whether the program can run. Throws InputError.
std::vector<std::string> words_of_needs(const Parameters& parameters)
{
    const auto words = split_shell_words(parameters.text(needs_key));
    if (!words) throw parameters.error(needs_key, "a quote or backslash at the end is left open");
    if (words->empty()) throw parameters.error(needs_key, "must name a program, such as \"python3 -c 'import scipy'\"");
    return *words;
}

/// The reason why the program cannot run here; nothing without `needs`, and where all is there.
std::optional<std::string> absence_of_program(const Parameters& parameters)
{
    if (!parameters.is_given(needs_key)) return std::nullopt;
    const fs::path folder = folder_of(parameters);
    const auto words = words_of_needs(parameters);
    for (const std::string& program : {words[0], command_words(parameters.text(command_key), {})[0]})
        if (std::string missing = missing_program(program, folder); !missing.empty()) return missing;
    const ProgramOutcome outcome = run_program(words, folder, parameters.number(limit_key), stop_if_interrupted);
    if (outcome.succeeded()) return std::nullopt;
    return fmt::format("what it needs is not there: {}", parameters.text(needs_key));
}

void check_command(const Parameters& parameters, const SampleRequest&, const SourceLocation& where)
{
    if (!parameters.is_given(command_key))
        throw InputError::at(where,
                             "sampler = \"command\": needs command, such as \"mysampler {points} {seed} {out}\"");
    try {
        const auto words = command_words(parameters.text(command_key), {});
        const std::string missing = missing_program(words[0], folder_of(parameters));
        if (!missing.empty() && !parameters.is_given(needs_key)) throw InputError(missing);
    } catch (const InputError& error) {
        throw parameters.error(command_key, error.what());
    }
    if (parameters.is_given(needs_key)) words_of_needs(parameters);
}

}

std::vector<std::string> command_words(const std::string& command, const CommandValues& values)
{
    auto words = split_shell_words(command);
    if (!words) throw InputError("a quote or backslash at the end is left open");
    if (words->empty()) throw InputError("must name a program");
    bool has_out = false;
    for (std::string& word : *words) word = replaced(word, values, has_out);
    if (!has_out)
        throw InputError(
            fmt::format("must have {{out}}, the file that the program writes; it may have {}", known_fields));
    return *std::move(words);
}

std::uint32_t command_seed(std::uint64_t seed, std::uint32_t realization)
{
    return std::max(1U, stream_key(seed, Purpose::other_program, realization)[0] >> 1);
}

SamplerSpec command_sampler()
{
    SamplerSpec spec;
    spec.name = "command";
    spec.title = "Command";
    spec.summary = "point sets from any program that writes them to a file";
    spec.dimensions = {2, 3};
    spec.parameters = {
        {.key = command_key,
         .kind = ParameterSpec::Kind::command,
         .help = fmt::format("a program and its arguments, with {}; run in the folder of the config", known_fields)},
        {.key = limit_key,
         .help = "how long the program may take before it is ended",
         .unit = "seconds",
         .maximum = 1e6,
         .exclusive_minimum = true,
         .otherwise = 60.0},
        {.key = needs_key,
         .kind = ParameterSpec::Kind::text,
         .help = "a command that ends with status 0 where the program can run, such as \"python3 -c 'import scipy'\"; "
                 "where it cannot, the series is left out, with a message",
         .unless_given = "by default a missing program is an error"},
    };
    spec.label = [](const Parameters& parameters) { return program_name(parameters.text(command_key)); };
    spec.check = check_command;
    spec.absence = absence_of_program;
    spec.outside_input = program_hash;
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<CommandSampler>(parameters, request);
    };
    return spec;
}

}
