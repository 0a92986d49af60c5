// The pages of the documentation that follow from the program's own descriptions: of methods, kinds of
// work, measures and commands.
#pragma once

#include "app/commands/command.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

// Examples of kinds of work that the manual shows: the files of docs/kinds come with the program.

/// The text of one. Throws std::out_of_range where there is none.
std::string_view example_file(std::string_view name);

/// The texts of pages in Markdown, by their file names relative to the folder of the documentation. They link to pages
/// and pictures that the checkout has there.
using ManualPages = std::map<std::string, std::string>;

/// A page a method, methods/NAME.md, and methods.md, which helps to choose one.
ManualPages method_pages();

/// methods.md as the checkout has it, which lacks the pages of methods.
std::string stored_choice_page();

/// A page for each other kind of work, kinds/TABLE-WORD.md, and beside-methods.md, which lists them. Pictures and
/// examples are those of docs/kinds.
ManualPages kind_pages();

/// All methods of the gallery in the plane, by the measures that methods are chosen by.
std::string scale_table();

/// The text of a page with what stands between `<!--= SOURCE -->` and `<!--/-->` put in anew from the tables that come
/// with the program. Sources: `measure NAME KEY DECIMALS`, of a method of the gallery, with its error; `value NAME KEY
/// DECIMALS`, without; the tables `scale`, `seams`, `even`, `averaged`, `sizes`, and `claims AGREEMENT`. Throws
/// InputError with the line of a source that is not there, of a marker that is not closed, or of tiles without errors
/// between sets.
std::string with_stored_results(const std::string& page, const std::string& file);

/// measures.md: every measure, what it means, and what is good and bad of it.
std::string measure_page();

/// commands.md: every command with all its options.
std::string command_page(const std::vector<Command>& commands);

/// Writes all of these and the curves of methods, methods/NAME.svg. Throws StorageError.
void write_manual(const std::filesystem::path& folder, const std::vector<Command>& commands);

}
