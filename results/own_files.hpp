// Files of an output folder that this program has written, told from those of others, which stay.
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace poissonlab {

/// Pages of a report beside the results; the overview is the first.
inline constexpr std::array own_pages{"index.html", "compare.html", "claims.html"};

/// Throws InputError, a line that begins with `begin` and `--out NAME: `, where no folder can be: for a file, standard
/// output, and a link that leads nowhere. Folders that are not there yet are fine.
void check_output_folder(const std::filesystem::path& out, const std::string& begin = {});

/// Throws InputError, `--out FOLDER: has an index.html that poissonlab did not write ...`, where the page is there and
/// is none of a report: these say in their heads what has written them.
void check_own_page(const std::filesystem::path& page);

/// Throws InputError where a file of an output folder that a run and its report replace is not theirs: results.json,
/// collection.json and the pages of the report. Folders that are not there, and those without such files, are fine.
void check_own_files(const std::filesystem::path& out);

}
