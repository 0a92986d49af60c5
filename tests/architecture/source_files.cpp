#include "tests/architecture/source_files.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace poissonlab::test {
namespace {

const std::array source_folders{"analysis", "app",    "base",    "cmake",   "docs",    "experiment", "host",
                                "kernels",  "python", "reports", "results", "runtime", "tests",      "tiles"};

const std::set<std::string> files_in_the_root{"CMakeLists.txt", "lab", "setup.py"};

const std::set<std::string> cpp_kinds{".cpp", ".hpp", ".h"};

const std::set<std::string> other_c_kinds{".c", ".cl", ".clh", ".frag", ".glsl", ".hlsl", ".js", ".ts", ".wgsl"};

const std::set<std::string> hash_kinds{".cmake", ".py", ".sh"};

bool is_source(const SourceFile& file)
{
    return file.is_cpp() || other_c_kinds.contains(file.kind()) || file.has_hash_comments();
}

std::vector<SourceFile> read_source_files()
{
    const std::filesystem::path root = source_folder();
    std::vector<SourceFile> files;
    const auto read = [&](const std::filesystem::path& place) {
        SourceFile file{place.lexically_relative(root).generic_string(), {}};
        if (!is_source(file)) return;
        file.text = read_whole_file(place);
        files.push_back(std::move(file));
    };
    for (const std::string& name : files_in_the_root) read(root / name);
    for (const char* folder : source_folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file()) read(entry.path());
    std::ranges::sort(files, {}, &SourceFile::path);
    return files;
}

}

std::string SourceFile::folder() const { return std::filesystem::path(path).parent_path().generic_string(); }

std::string SourceFile::kind() const { return std::filesystem::path(path).extension(); }

bool SourceFile::is_cpp() const { return cpp_kinds.contains(kind()); }

bool SourceFile::has_hash_comments() const
{
    return hash_kinds.contains(kind()) || path == "lab" || std::filesystem::path(path).filename() == "CMakeLists.txt";
}

const std::vector<SourceFile>& source_files()
{
    static const std::vector<SourceFile> files = read_source_files();
    return files;
}

}
