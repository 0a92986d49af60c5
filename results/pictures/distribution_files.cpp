#include "results/pictures/distribution_files.hpp"

#include "base/files/whole_file.hpp"

namespace poissonlab {

void DistributionFiles::add_marks(const std::string& name, const MarkPicture& picture, const std::string& caption,
                                  DistributionResult& result)
{
    write_whole_file(add(name), mark_picture_json(picture));
    result.pictures.push_back({name, caption});
}

}
