// This function stands in for pictures as numbers where a program has no kinds of work: those that are analysed as
// masks ask for the module. A file that is not there builds nothing.
#include "base/errors/errors.hpp"
#include "base/errors/missing_module.hpp"
#include "base/files/file_kind.hpp"
#include "base/images/raw_picture.hpp"

#include <fmt/format.h>

namespace poissonlab {

PictureHeader read_picture_header(const std::filesystem::path& path)
{
    if (const std::string problem = lack_of_file(path); !problem.empty())
        throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), problem));
    throw MissingModule("distributions");
}

}
