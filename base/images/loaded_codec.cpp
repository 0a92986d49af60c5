// OpenImageIO brings some 250 libraries, which take half a second to load: it is in a module of its own. Most commands,
// and processes that work for others, need none.
#include "base/images/loaded_codec.hpp"

#include "base/programs/loaded_module.hpp"

#include <dlfcn.h>

namespace poissonlab {
namespace {

/// Nearly half of all symbols are of these libraries, which look them up among all 250 when these are loaded together,
/// and among their own when they come first: that saves a quarter of the time. One that is not there is loaded later
/// under another name.
void load_largest_libraries()
{
    for (const char* library : {"libopenvdb.so.10.0", "libgdal.so.32"}) ::dlopen(library, RTLD_LAZY | RTLD_LOCAL);
}

const PictureCodec* load_codec()
{
    load_largest_libraries();
    void* const function =
        function_of_module("poissonlab_pictures", picture_codec_function, "pictures need OpenImageIO");
    return reinterpret_cast<PictureCodecFunction>(function)();
}

}

const PictureCodec& loaded_codec()
{
    static const PictureCodec* const loaded = load_codec(); // never unloaded
    return *loaded;
}

}
