// OpenImageIO brings some 250 libraries, which take half a second to load: it is in a module of its own. Most commands,
// and processes that work for others, need none.
#include "base/images/loaded_codec.hpp"

#include "base/programs/loaded_module.hpp"

#include <dlfcn.h>

#include <cstdlib>

namespace poissonlab {
namespace {

/// Tells whether the C library's functions are its own. Sanitizers, other allocators and LD_PRELOAD put theirs in front
/// of these for the whole process: then none may be looked up elsewhere, or memory of one allocator is given to the
/// other.
bool has_plain_c_library()
{
    Dl_info allocator{}, library{};
    return std::getenv("LD_PRELOAD") == nullptr &&
           ::dladdr(reinterpret_cast<const void*>(&std::malloc), &allocator) != 0 &&
           ::dladdr(reinterpret_cast<const void*>(&std::abort), &library) != 0 &&
           allocator.dli_fbase == library.dli_fbase;
}

/// Nearly half of all symbols are of these libraries, which look them up among all 250 when these are loaded together,
/// and among their own when they come first: that saves a quarter of the time, and another quarter when they do not ask
/// the program's own 50 libraries before. One that is not there is loaded later under another name.
void load_largest_libraries()
{
    const int own_first = has_plain_c_library() ? RTLD_DEEPBIND : 0;
    for (const char* library : {"libopenvdb.so.10.0", "libgdal.so.32"})
        ::dlopen(library, RTLD_LAZY | RTLD_LOCAL | own_first);
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
