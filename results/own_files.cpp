#include "results/own_files.hpp"

#include "base/errors/errors.hpp"
#include "base/files/output_place.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <string_view>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// Each file of the program has one of these marks near its beginning. Pages of version 0.2 are known by their style
/// sheet alone.
constexpr std::array<std::string_view, 2> page_marks{R"(<meta name="generator" content="poissonlab")",
                                                     R"(/report.css"/>)"};
constexpr std::array<std::string_view, 1> results_marks{"\"poissonlab-results\""};
constexpr std::array<std::string_view, 1> collection_marks{"\"poissonlab-collection\""};

constexpr std::size_t bytes_with_mark = 4096;

bool has_mark(const fs::path& file, std::span<const std::string_view> marks)
{
    std::string begin(bytes_with_mark, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    return std::ranges::any_of(marks, [&](std::string_view mark) { return begin.find(mark) != begin.npos; });
}

void check_own_file(const fs::path& file, std::span<const std::string_view> marks)
{
    std::error_code unknown;
    const bool is_there = fs::exists(fs::symlink_status(file, unknown));
    if (!is_there) return;
    // An empty file is nothing that could be lost: a machine that stops leaves such.
    if (fs::is_regular_file(file, unknown) && (fs::is_empty(file, unknown) || has_mark(file, marks))) return;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const std::string name = file.filename();
    throw InputError(fmt::format("--out {}: has {} {} that poissonlab did not write; choose another folder",
                                 printable(folder.string()), name == own_pages.front() ? "an" : "a", name));
}

}

void check_output_folder(const fs::path& out, const std::string& begin)
{
    std::error_code unknown;
    const std::string option = fmt::format("{}--out {}: ", begin, printable(out.string()));
    if (names_standard_output(out))
        throw InputError(option + "standard output cannot hold a folder; a folder is needed");
    if (fs::is_symlink(out, unknown) && !fs::exists(out, unknown))
        throw InputError(option + "is a link whose target does not exist; a folder is needed");
    if (fs::exists(out, unknown) && !fs::is_directory(out, unknown))
        throw InputError(option + "is a file; a folder is needed");
}

void check_own_page(const fs::path& page) { check_own_file(page, page_marks); }

void check_own_files(const fs::path& out)
{
    check_own_file(out / file_names::results, results_marks);
    check_own_file(out / file_names::collection, collection_marks);
    for (const char* page : own_pages) check_own_page(out / page);
}

}
