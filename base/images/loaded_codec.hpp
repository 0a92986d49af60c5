// The module that holds OpenImageIO, loaded when the first picture is read or written.
#pragma once

#include "base/images/picture_codec.hpp"

namespace poissonlab {

/// Throws StorageError where the module, or a library of it, cannot be loaded.
const PictureCodec& loaded_codec();

}
