// OpenImageIO brings some 250 libraries, which take a third of a second to load: it is in a module of its own. Most
// commands, and processes that work for others, need none.
#include "base/images/loaded_codec.hpp"

#include "base/errors/errors.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// The file that this code is in: the program, or a library that holds the laboratory.
fs::path own_file()
{
    Dl_info info{};
    std::error_code error;
    if (::dladdr(reinterpret_cast<const void*>(&loaded_codec), &info) != 0 && info.dli_fname) {
        const fs::path file = info.dli_fname;
        if (file.extension() == ".so") return fs::absolute(file, error);
    }
    return fs::read_symlink("/proc/self/exe", error); // a program's name alone may be relative to anything
}

/// Beside the program, or where it is when it is installed with the program or the Python package, or where it was
/// built.
fs::path module_file()
{
    const fs::path built = POISSONLAB_PICTURE_MODULE;
    const fs::path folder = own_file().parent_path();
    std::error_code error;
    for (const fs::path& place :
         {folder, folder / POISSONLAB_INSTALLED_MODULES, folder / POISSONLAB_MODULES_FROM_PYTHON})
        if (fs::exists(place / built.filename(), error)) return place / built.filename();
    return built;
}

const PictureCodec* load_codec()
{
    void* const module = ::dlopen(module_file().c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const function = module ? ::dlsym(module, picture_codec_function) : nullptr;
    if (!function) throw StorageError(std::string("pictures need OpenImageIO: ") + ::dlerror());
    return reinterpret_cast<PictureCodecFunction>(function)();
}

}

const PictureCodec& loaded_codec()
{
    static const PictureCodec* const loaded = load_codec(); // never unloaded
    return *loaded;
}

}
