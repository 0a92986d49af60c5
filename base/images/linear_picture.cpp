#include "base/images/linear_picture.hpp"

#include "base/errors/errors.hpp"
#include "base/images/loaded_codec.hpp"

#include <fmt/format.h>

namespace poissonlab {

LinearPicture read_linear_picture(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw InputError(fmt::format("{}: cannot read the picture: no such file", path.string()));
    LinearPicture picture;
    const std::string problem = loaded_codec().read_linear(path, picture);
    if (!problem.empty()) throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), problem));
    return picture;
}

}
