#include "base/images/linear_picture.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/images/loaded_codec.hpp"
#include "base/images/png_damage.hpp"

#include <fmt/format.h>

namespace poissonlab {

LinearPicture read_linear_picture(const std::filesystem::path& path, AlphaUse use)
{
    LinearPicture picture;
    std::string problem = lack_of_file(path);
    if (problem.empty()) problem = png_damage(path);
    if (problem.empty()) problem = loaded_codec().read_linear(path, use, picture);
    if (!problem.empty()) throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), problem));
    return picture;
}

}
