// This function stands in for pictures as numbers where a program has no kinds of work: those that are analysed as
// masks ask for the module.
#include "base/errors/missing_module.hpp"
#include "base/images/raw_picture.hpp"

namespace poissonlab {

PictureHeader read_picture_header(const std::filesystem::path& /*path*/) { throw MissingModule("distributions"); }

}
