#include "results/pictures/distribution_files.hpp"

#include "base/files/whole_file.hpp"
#include "results/pictures/curve_chart.hpp"

namespace poissonlab {

void DistributionFiles::add_marks(const std::string& name, const MarkPicture& picture, const std::string& caption,
                                  DistributionResult& result)
{
    write_whole_file(add(name), mark_picture_json(picture));
    result.pictures.push_back({name, caption});
}

void DistributionFiles::add_curves(const std::string& name, const CurveChart& chart, const std::string& caption,
                                   DistributionResult& result)
{
    const std::string file = name + curves_ending;
    write_whole_file(add(file), curve_chart_json(chart));
    result.pictures.push_back({file, caption});
}

}
