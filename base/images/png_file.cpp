// OpenImageIO brings some 250 libraries, which take a third of a second to load: it is in a module of its own, which is
// loaded when the first picture is read or written. Most commands, and processes that work for others, need none.
#include "base/images/png_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/picture_codec.hpp"

#include <dlfcn.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// Beside the program, or where it was built.
fs::path module_file()
{
    const fs::path built = POISSONLAB_PICTURE_MODULE;
    std::error_code error;
    const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / built.filename();
    return fs::exists(beside, error) ? beside : built;
}

const PictureCodec* load_codec()
{
    void* const module = ::dlopen(module_file().c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const function = module ? ::dlsym(module, picture_codec_function) : nullptr;
    if (!function) throw StorageError(std::string("pictures need OpenImageIO: ") + ::dlerror());
    return reinterpret_cast<PictureCodecFunction>(function)();
}

const PictureCodec& codec()
{
    static const PictureCodec* const loaded = load_codec(); // never unloaded
    return *loaded;
}

}

void write_png(const fs::path& path, const PngLayout& layout, const PngRows& rows)
{
    write_whole_file(path, [&](const fs::path& temporary) {
        errno = 0;
        std::string problem = codec().write(temporary, layout, rows);
        if (problem.empty()) return;
        // OpenImageIO says what failed, and not always why.
        if (errno != 0) problem += ": " + std::generic_category().message(errno);
        throw StorageError(path.string() + ": cannot write the picture: " + problem);
    });
}

PngPixels read_png(const fs::path& path)
{
    PngPixels pixels;
    const std::string problem = codec().read(path, pixels);
    if (!problem.empty()) throw StorageError(path.string() + ": cannot read the picture: " + problem);
    return pixels;
}

}
