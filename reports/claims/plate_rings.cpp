// False rings in the pictures of the zone plate, which claims look at.
#include "analysis/zone_plate/false_rings.hpp"
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/errors/errors.hpp"
#include "base/images/square_image.hpp"
#include "base/programs/side_by_side.hpp"
#include "reports/claims/claim_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace poissonlab {

std::map<const ReportSeries*, ClaimSeries::Rings> rings_in_plates(const std::vector<const ReportSeries*>& series)
{
    std::vector<const ReportSeries*> plates;
    std::ranges::copy_if(series, std::back_inserter(plates), [](const auto* s) {
        return s->stored->zone_plate && s->stored->zone_plate->size >= smallest_false_rings_picture;
    });
    std::map<int, SquareImage> references;
    for (const auto* plate : plates) references.try_emplace(plate->stored->zone_plate->size);
    for (auto& [size, reference] : references) reference = zone_plate_reference(size);
    std::vector<ClaimSeries::Rings> found(plates.size());
    for_all_side_by_side(plates.size(), [&](std::size_t i) {
        const auto file = plates[i]->run->folder / plates[i]->stored->zone_plate->file;
        const auto picture = read_square_image(file);
        const auto reference = references.find(picture.size);
        if (reference == references.end())
            throw InputError(fmt::format("{}: must have {} pixels along each axis, as results.json says", file.string(),
                                         plates[i]->stored->zone_plate->size));
        const auto rings = strongest_false_rings(picture, reference->second);
        found[i] = {rings.strength, rings.at_the_plate, false_rings_bound(picture.pixels.size())};
    });
    std::map<const ReportSeries*, ClaimSeries::Rings> rings;
    for (std::size_t i = 0; i < plates.size(); ++i) rings[plates[i]] = found[i];
    return rings;
}

}
