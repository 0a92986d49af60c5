#include "reports/plots/gnuplot.hpp"

#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/files/whole_file.hpp"
#include "base/programs/program_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <limits>
#include <thread>

extern char** environ;

namespace poissonlab {

namespace {

/// A kind of picture, and how gnuplot is told about it.
struct Terminal
{
    std::string extension;
    std::string options;
    int scale;
};

const Terminal svg_terminal{"svg", "svg enhanced font 'sans-serif,12' linewidth 1", 1};
const Terminal png_terminal{"png", "pngcairo enhanced font 'sans-serif,12' fontscale 2 linewidth 2", 2};

std::string set_terminal(const Terminal& terminal, const GnuplotPicture& picture)
{
    return fmt::format("set terminal {} size {},{}\n", terminal.options, terminal.scale * picture.width,
                       terminal.scale * picture.height);
}

//// The exit status of our script if gnuplot finds no fonts.
constexpr int status_without_letters = 77;

/// Without fonts gnuplot draws PNG files without letters and says nothing. It leaves no margin for them either, which
/// shows. SVG files leave the letters to the browser.
std::string font_check()
{
    return fmt::format(
        "set terminal pngcairo font 'sans-serif,12' size 200,200\nset output 'letters.png'\nplot [0:1] x\n"
        "if (GPVAL_TERM_XMIN < 2) {{ exit status {} }}\nset output\n",
        status_without_letters);
}

/// One of the processes of a terminal: every so many pictures from the first on.
struct Part
{
    std::size_t first = 0;
    std::size_t step = 1;
};

std::string script_for(const Terminal& terminal, const std::vector<GnuplotPicture>& pictures, const Part& part)
{
    std::string script = "set encoding utf8\n";
    if (part.first == 0 && terminal.scale > 1) script += font_check();
    for (std::size_t i = part.first; i < pictures.size(); i += part.step)
        script += fmt::format("reset session\n{}set output '{}.{}'\n{}\nset output\n",
                              set_terminal(terminal, pictures[i]), i, terminal.extension, pictures[i].commands);
    return script;
}

/// Bytes of what gnuplot said that a message repeats.
constexpr std::size_t most_said = 500;

/// The environment without the user's language, which would change number formats and messages.
std::vector<std::string> neutral_environment()
{
    std::vector<std::string> result{"LC_ALL=C.UTF-8"};
    for (char** entry = environ; *entry; ++entry) {
        const std::string_view text = *entry;
        if (!text.starts_with("LC_") && !text.starts_with("LANG") && !text.starts_with("GNUTERM"))
            result.emplace_back(text);
    }
    return result;
}

/// Messages of several lines, and what gnuplot points at with lines of blanks, as one line.
std::string in_one_line(const std::string& text)
{
    std::string line;
    for (const char c : text) {
        const bool is_blank = static_cast<unsigned char>(c) <= ' ';
        if (!is_blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// The end of gnuplot. It has a process group of its own: Ctrl-C in the terminal does not reach it, but ends it
/// together with this process.
ProgramOutcome outcome_of(const std::string& script, const std::filesystem::path& folder)
try {
    return run_program(
        {"gnuplot", "--default-settings", script}, folder, std::numeric_limits<double>::infinity(), [] {},
        neutral_environment());
} catch (const InputError& error) {
    throw StorageError(error.what()); // the user has not asked for gnuplot
}

/// Runs gnuplot on a script in the folder and waits for it.
void run_script(const std::filesystem::path& folder, const std::string& script)
{
    const ProgramOutcome outcome = outcome_of(script, folder);
    if (outcome.succeeded()) return;
    if (outcome.status == status_without_letters)
        throw StorageError("gnuplot finds no fonts, and would leave out all letters: install the package "
                           "fonts-dejavu-core");
    const std::string said = shortened(in_one_line(outcome.output), most_said);
    const std::string how = outcome.signal != 0 ? fmt::format("was ended by signal {}", outcome.signal)
                                                : fmt::format("failed with status {}", outcome.status);
    throw StorageError("gnuplot " + how + (said.empty() ? "" : ": " + said));
}

std::filesystem::path file_of(const GnuplotPicture& picture, const Terminal& terminal)
{
    return picture.stem.string() + "." + terminal.extension;
}

/// All that a picture depends on.
std::string input_of(const GnuplotPicture& picture, const Terminal& terminal)
{
    return set_terminal(terminal, picture) + picture.commands;
}

/// A picture that gnuplot says it has drawn. Throws StorageError where there is none, or half of one; `target` is what
/// the user knows of.
std::string drawn_picture(const std::filesystem::path& file, const std::filesystem::path& target)
{
    const auto fail = [&](const std::string& why) {
        throw StorageError(fmt::format("gnuplot ended without an error, but its picture for {} {}: "
                                       "is the right gnuplot in PATH?",
                                       target.string(), why));
    };
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) fail("is missing");
    std::string picture = read_whole_file(file);
    const bool is_svg = file.extension() == ".svg";
    const std::string_view begin = is_svg ? std::string_view("<?xml") : std::string_view("\x89PNG\r\n");
    const std::string_view end = is_svg ? std::string_view("</svg>") : std::string_view("IEND");
    const std::size_t tail = picture.size() - std::min<std::size_t>(picture.size(), 16);
    if (!picture.starts_with(begin) || picture.find(end, tail) == std::string::npos) fail("is damaged");
    return picture;
}

/// Runs all processes of a terminal at once and waits for them.
void run_gnuplot(const std::filesystem::path& folder, const std::vector<GnuplotPicture>& pictures,
                 const Terminal& terminal)
{
    if (!find_program("gnuplot", folder))
        throw StorageError("gnuplot is not installed; the report's curves need it: install the package gnuplot-nox");
    std::vector<std::future<void>> processes;
    const std::size_t count = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), pictures.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto script = fmt::format("script.{}{}", terminal.extension, i);
        write_whole_file(folder / script, script_for(terminal, pictures, {i, count}));
        processes.push_back(std::async(std::launch::async, run_script, folder, script));
    }
    for (auto& process : processes) process.get();
}

void draw_files(const std::vector<GnuplotPicture>& all, const Terminal& terminal, PictureStore* store)
{
    std::vector<GnuplotPicture> pictures;
    for (const auto& picture : all)
        if (!store || !store->is_current({file_of(picture, terminal)}, input_of(picture, terminal)))
            pictures.push_back(picture);
    if (!pictures.empty()) {
        const ScratchFolder folder;
        run_gnuplot(folder.path(), pictures, terminal);
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            const auto target = file_of(pictures[i], terminal);
            write_whole_file(target,
                             drawn_picture(folder.path() / fmt::format("{}.{}", i, terminal.extension), target));
        }
    }
    if (store)
        for (const auto& picture : all) store->note({file_of(picture, terminal)}, input_of(picture, terminal));
}

/// Keeps the pictures of an earlier report that show the same, and removes the others.
void keep_current_files(const std::vector<GnuplotPicture>& pictures, const Terminal& terminal, PictureStore& store)
{
    for (const auto& picture : pictures) {
        const auto file = file_of(picture, terminal);
        const auto input = input_of(picture, terminal);
        std::error_code ignored;
        if (store.is_current({file}, input))
            store.note({file}, input);
        else
            std::filesystem::remove(file, ignored);
    }
}

}

void draw_with_gnuplot(const std::vector<GnuplotPicture>& pictures, PrintPictures print, PictureStore* store)
{
    draw_files(pictures, svg_terminal, store);
    if (print == PrintPictures::drawn)
        draw_files(pictures, png_terminal, store);
    else if (store)
        keep_current_files(pictures, png_terminal, *store);
}

std::string gnuplot_quoted(const std::string& text)
{
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';
        quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return quoted + "'";
}

}
