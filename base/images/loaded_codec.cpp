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

}

const PictureCodec& loaded_codec()
{
    static const PictureCodec* const loaded = load_codec(); // never unloaded
    return *loaded;
}

}
