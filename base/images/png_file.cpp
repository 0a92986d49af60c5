#include "base/images/png_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/loaded_codec.hpp"

#include <cerrno>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace poissonlab {

void write_png(const fs::path& path, const PngLayout& layout, const PngRows& rows)
{
    write_whole_file(path, [&](const fs::path& temporary) {
        errno = 0;
        std::string problem = loaded_codec().write(temporary, layout, rows);
        if (problem.empty()) return;
        // OpenImageIO says what failed, and not always why.
        if (errno != 0) problem += ": " + std::generic_category().message(errno);
        throw StorageError(path.string() + ": cannot write the picture: " + problem);
    });
}

PngPixels read_png(const fs::path& path)
{
    PngPixels pixels;
    const std::string problem = loaded_codec().read(path, pixels);
    if (!problem.empty()) throw StorageError(path.string() + ": cannot read the picture: " + problem);
    return pixels;
}

}
