#include "base/images/png_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/loaded_codec.hpp"
#include "base/images/png_damage.hpp"

#include <cerrno>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace poissonlab {

namespace {

/// Lets a function of the codec write; it returns what went wrong.
template <class Write>
void write_picture(const fs::path& path, const Write& write)
{
    write_whole_file(path, [&](const fs::path& temporary) {
        errno = 0;
        std::string problem = write(temporary);
        if (problem.empty()) return;
        // OpenImageIO says what failed, and not always why.
        if (errno != 0) problem += ": " + std::generic_category().message(errno);
        throw StorageError(path.string() + ": cannot write the picture: " + problem);
    });
}

/// Lets a function of the codec read; it returns what went wrong.
template <class Pixels, class Read>
Pixels read_picture(const fs::path& path, const Read& read)
{
    Pixels pixels;
    std::string problem = png_damage(path);
    if (problem.empty()) problem = read(pixels);
    if (!problem.empty()) throw StorageError(path.string() + ": cannot read the picture: " + problem);
    return pixels;
}

}

void write_png(const fs::path& path, const PngPixels& pixels)
{
    write_png(path, {pixels.width, pixels.height, pixels.channels},
              [&](int first, int) { return &pixels.values[pixels.at(0, first, 0)]; });
}

void write_png(const fs::path& path, const PngLayout& layout, const PngRows& rows)
{
    write_picture(path, [&](const fs::path& temporary) { return loaded_codec().write(temporary, layout, rows); });
}

void write_deep_png(const fs::path& path, const DeepPixels& pixels)
{
    write_picture(path, [&](const fs::path& temporary) { return loaded_codec().write_deep(temporary, pixels); });
}

PngPixels read_png(const fs::path& path)
{
    return read_picture<PngPixels>(path, [&](PngPixels& pixels) { return loaded_codec().read(path, pixels); });
}

DeepPixels read_deep_png(const fs::path& path)
{
    return read_picture<DeepPixels>(path, [&](DeepPixels& pixels) { return loaded_codec().read_deep(path, pixels); });
}

}
