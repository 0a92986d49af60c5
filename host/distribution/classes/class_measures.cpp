#include "host/distribution/classes/class_points.hpp"

#include "analysis/measures/cell_grid.hpp"
#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/programs/interrupt.hpp"
#include "base/regions/region_units.hpp"
#include "host/distribution/classes/class_density.hpp"
#include "host/distribution/classes/class_lines.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poissonlab {

// Looks at the cells around each point of the smaller set, ring after ring, until cells are farther away than the
// least distance so far.

namespace {

/// Calls visit(cell) for the cells that are `ring` cells away from a cell, around the torus; some twice where the torus
/// is no wider.
template <int D, typename Visit>
void for_each_in_ring(const std::array<int, D>& cell, int ring, int cells, const Visit& visit)
{
    std::array<int, D> offset;
    offset.fill(-ring);
    for (;;) {
        bool is_in_ring = false;
        std::size_t index = 0;
        for (int k = D - 1; k >= 0; --k) {
            is_in_ring = is_in_ring || std::abs(offset[k]) == ring;
            const int along = ((cell[k] + offset[k]) % cells + cells) % cells;
            index = index * static_cast<std::size_t>(cells) + static_cast<std::size_t>(along);
        }
        if (is_in_ring) visit(index);
        int k = 0;
        while (k < D && ++offset[k] > ring) offset[k++] = -ring;
        if (k == D) return;
    }
}

/// Squares in units of 2^-64, of coordinates that are rounded to multiples of 2^-32.
template <int D>
double least_between(const PointSet& few, const PointSet& many)
{
    const CellGrid<D> grid(many, CellGrid<D>::cells_of(many.size()));
    const auto fixed = [](double x) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x * 0x1p32)); };
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t i = 0; i < few.size(); ++i) {
        TorusPoint<D> from;
        std::array<int, D> cell;
        for (std::size_t k = 0; k < D; ++k) {
            from[k] = fixed(few[i][k]);
            cell[k] = std::min(static_cast<int>(few[i][k] * grid.cells), grid.cells - 1);
        }
        for (int ring = 0; 2 * ring <= grid.cells + 1; ++ring) {
            // Points of a ring are a ring less one cell away at least.
            const double away = (ring - 1) * 0x1p32 / grid.cells;
            if (ring > 1 && away * away >= static_cast<double>(least)) break;
            for_each_in_ring<D>(cell, ring, grid.cells, [&](std::size_t index) {
                for (std::size_t j = grid.starts[index]; j < grid.starts[index + 1]; ++j) {
                    TorusPoint<D> to;
                    for (int k = 0; k < D; ++k) to[k] = fixed(grid.position[k][j]);
                    least = std::min(least, squared_distance<D>(from, to));
                }
            });
        }
    }
    return std::sqrt(static_cast<double>(least)) * 0x1p-32;
}

}

double least_distance_between(const PointSet& a, const PointSet& b)
{
    if (a.size() == 0 || b.size() == 0) return std::numeric_limits<double>::infinity();
    const bool is_first_larger = a.size() > b.size();
    const PointSet &few = is_first_larger ? b : a, &many = is_first_larger ? a : b;
    return a.dimension == 2 ? least_between<2>(few, many) : least_between<3>(few, many);
}

namespace {

void append_columns(std::string& text, const CrossSpectra& spectra, std::size_t bin)
{
    text += fmt::format(",{:.9g}", spectra.power.back()[bin]);
    for (std::size_t i = 0; i + 1 < spectra.power.size(); ++i) text += fmt::format(",{:.9g}", spectra.power[i][bin]);
    for (const std::vector<double>& cross : spectra.cross) text += fmt::format(",{:.9g}", cross[bin]);
}

void append_names(std::string& text, const std::vector<std::uint32_t>& used, const std::string& end)
{
    text += ",all" + end;
    for (const std::uint32_t i : used) text += fmt::format(",class_{}{}", i, end);
    for (std::size_t i = 0; i < used.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) text += fmt::format(",cross_{}_{}{}", used[j], used[i], end);
}

double radius_of(double least, std::size_t points, int dimension)
{
    if (points < 2) return 0;
    return dimension == 1 ? least * static_cast<double>(points) : relative_radius(least, points, dimension);
}

}

ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first)
{
    std::vector<UsedSpectra> sets{{used_classes(first.points), class_spectra(first.points)}};
    const std::size_t bins = sets.front().spectra.bins();
    for (std::uint32_t number = 1; number < settings.sets; ++number) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("spectra: set {} of {}", number + 1, settings.sets));
        const ClassSet set = first.tiles ? classes_by_tiles(first.tiles, settings, seed, place, number)
                                         : throw_classes(settings, seed, place, number);
        sets.push_back({used_classes(set.points), class_spectra(set.points, bins)});
    }
    return mean_spectra(sets);
}

std::string spectra_csv(const ClassSpectra& spectra)
{
    std::string text = "frequency";
    append_names(text, spectra.classes, "");
    if (spectra.sets > 1) append_names(text, spectra.classes, "_error");
    text += '\n';
    for (std::size_t k = 0; k < spectra.mean.bins(); ++k) {
        text += fmt::format("{}", k + 1);
        append_columns(text, spectra.mean, k);
        if (spectra.sets > 1) append_columns(text, spectra.error, k);
        text += '\n';
    }
    return text;
}

std::vector<double> density_errors(const ClassPart& part, const ClassedPoints& points)
{
    std::vector<double> errors;
    for (std::uint32_t i = 0; i < part.densities.size(); ++i)
        errors.push_back(density_error(part.densities[i], points.of_class(i)));
    return errors;
}

double density_error(const ClassSet& set, std::size_t of)
{
    return set.density_errors.size() == 1 && set.work.request.parts == 1 ? set.density_errors[0][of] : -1;
}

namespace {

/// Returns the numbers of points of a class in the parts of a set.
std::vector<double> counts_in_parts(const ClassedPoints& points, std::size_t of)
{
    std::vector<double> counts;
    std::size_t at = 0;
    for (const std::size_t end : points.part_ends) {
        counts.push_back(0);
        for (; at < end; ++at) counts.back() += points.classes[at] == of;
    }
    return counts;
}

}

std::vector<std::string> density_notes(const ClassSet& set)
{
    constexpr double told = 0.01;
    const std::size_t parts = set.density_errors.size();
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < set.points.is_full.size(); ++i) {
        double largest = 0;
        std::size_t worst = 0;
        const std::vector<double> counts = counts_in_parts(set.points, i);
        for (std::size_t part = 0; part < parts; ++part) {
            const double error = set.density_errors[part][i];
            if (counts[part] == 0 || error <= std::max({told, 2 / counts[part], largest})) continue;
            largest = error;
            worst = part;
        }
        if (largest == 0) continue;
        notes.push_back(fmt::format(
            "class {} does not follow its density everywhere, as its distance leaves no room where it is densest: a "
            "sixteenth of the density{} has {:.2g} % of the points more or less than it should have",
            i, parts > 1 ? fmt::format(" in features[{}]", (*set.work.features)[worst].number) : "", 100 * largest));
    }
    return notes;
}

ClassDistances least_distances(const ClassSet& set)
{
    if (set.is_on_lines()) return least_in_plane(set.points);
    const std::size_t classes = set.points.is_full.size();
    std::vector<PointSet> sets;
    for (std::uint32_t i = 0; i < classes; ++i) sets.push_back(set.points.of_class(i));
    ClassDistances least(classes);
    for (std::size_t i = 0; i < classes; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            least.set(i, j, i == j ? min_toroidal_distance(sets[i]) : least_distance_between(sets[i], sets[j]));
    return least.scaled(set.work.side);
}

std::vector<DistributionNumber> class_numbers(const ClassSet& set)
{
    const ClassDistances least = least_distances(set);
    const std::vector<std::size_t> counts = set.points.counts();
    const std::size_t all = set.points.points.size();
    const int d = set.dimension();
    const double unit = std::pow(set.size(), 1.0 / d);
    const ClassDistances kept = set.kept();
    double least_of_all = INFINITY;
    std::vector<DistributionNumber> numbers;
    numbers.push_back({"points", "Points", static_cast<double>(all), "of all classes"});
    if (set.is_on_lines())
        numbers.push_back({"length", "Length", set.size(),
                           "of the lines that obstacles leave, in " +
                               (set.region() ? length_units(*set.region()) : "units of the region")});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        numbers.push_back({fmt::format("points_{}", i), fmt::format("Points of class {}", i),
                           static_cast<double>(counts[i]),
                           set.points.is_full[i] ? "no further one fits" : "as asked for"});
        numbers.push_back({fmt::format("relative_radius_{}", i), fmt::format("Relative radius of class {}", i),
                           radius_of(least.at(i, i) / unit, counts[i], d),
                           set.is_on_lines()
                               ? "of its points alone: least distance over the length of the lines for each point"
                               : "of its points alone"});
        for (std::size_t j = 0; j <= i; ++j) least_of_all = std::min(least_of_all, least.at(i, j));
    }
    numbers.push_back({"relative_radius", "Relative radius", radius_of(least_of_all / unit, all, d), "of all points"});
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (const double error = density_error(set, i); error >= 0)
            numbers.push_back({fmt::format("density_error_{}", i), fmt::format("Density error of class {}", i), error,
                               "the largest share of its points by which a sixteenth of its density has too many or "
                               "too few"});
    for (std::size_t i = 0; i < counts.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            numbers.push_back({fmt::format("distance_{}_{}", j, i),
                               fmt::format("Distance {}, {}", j, i),
                               kept.at(i, j),
                               "that the two classes keep",
                               {},
                               true});
            if (std::isfinite(least.at(i, j)))
                numbers.push_back({fmt::format("least_{}_{}", j, i),
                                   fmt::format("Least distance {}, {}", j, i),
                                   least.at(i, j),
                                   "of points of the two classes",
                                   {},
                                   true});
        }
    return numbers;
}

DistributionTable distance_table(const ClassSet& set)
{
    const ClassDistances least = least_distances(set), kept = set.kept();
    DistributionTable table{
        "Distances that classes keep, and the least that there are", {"classes", "kept", "least"}, {}};
    for (std::size_t i = 0; i < least.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            table.rows.push_back({fmt::format("{}, {}", j, i), fmt::format("{:.6g}", kept.at(i, j)),
                                  std::isfinite(least.at(i, j)) ? fmt::format("{:.6g}", least.at(i, j)) : "none"});
    return table;
}

}
