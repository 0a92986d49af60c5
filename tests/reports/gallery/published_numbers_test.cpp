// The gallery beside published numbers: what docs/gallery/README.md says of them is what the tables have.
#include "reports/gallery/gallery.hpp"

#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A number as it was published, or follows from theory.
struct PublishedNumber
{
    std::string method, measure;
    std::string words;            ///< in the table
    double least, most;           ///< what those words leave open: half a digit, an error, a range
    bool agrees = true;           ///< within five errors; else the table says why not
    double points_of_one_set = 0; ///< size of the set that the number was measured on, if it was one
    double error = 0;             ///< of the gallery's number, where that was measured on one set
};

/// The deviation of an estimate of the variance of cell areas: cells are nearly gamma distributed with the shape
/// 1 / 0.2802, whose kurtosis is 3 + 6 * 0.2802, and nearly independent.
const double area_variance_error = 0.2802 * std::sqrt((2 + 6 * 0.2802) / 16384);

const std::vector<PublishedNumber>& published_numbers()
{
    static const std::vector<PublishedNumber> numbers = {
        {"random", "mean_nearest_distance", "0.46530", 0.465297, 0.465308},
        {"random", "voronoi_area_variance", "0.2802", 0.28015, 0.28025, true, 0, area_variance_error},
        {"random", "oscillation", "0.112", 0.1115, 0.1125},
        {"random-3d", "mean_nearest_distance", "0.49352", 0.493517, 0.493528},
        {"regular", "relative_radius", "0.93060", 0.930595, 0.930615},
        {"regular-3d", "relative_radius", "0.89090", 0.890890, 0.890905},
        {"hexagonal", "relative_radius", "1", 1, 1, false},
        {"hexagonal-3d", "relative_radius", "1", 1, 1},
        {"dart-throwing-stop-saturation", "covered_fraction", "0.54707", 0.5470707, 0.5470763},
        {"dart-throwing-stop-saturation", "low_frequency_intercept", "0.0587", 0.05865, 0.05875},
        {"dart-throwing-stop-saturation-3d", "covered_fraction", "0.38413", 0.3841286, 0.3841328},
        {"dart-throwing-stop-saturation-3d", "low_frequency_intercept", "0.0558", 0.05575, 0.05585},
        {"dart-throwing-rho-0.75", "mean_nearest_distance", "0.806", 0.8055, 0.8065, true, 4096},
        {"relaxation-dart-throwing-attempts-1000", "relative_radius", "0.68", 0.675, 0.685},
        {"relaxation-dart-throwing-attempts-1000-3d", "relative_radius", "0.70", 0.695, 0.705},
        {"lloyd-i-100", "relative_radius", "0.75 to 0.85", 0.75, 0.85},
        {"lloyd-i-100", "mean_nearest_distance", "0.942", 0.9415, 0.9425, false, 4096},
        {"sector-darts", "relative_radius", "0.70", 0.695, 0.705, false},
        {"sample-elimination", "relative_radius", "0.692", 0.6915, 0.6925},
        {"farthest-point", "relative_radius", "0.925", 0.9245, 0.9255},
        {"farthest-point", "mean_nearest_distance", "0.932", 0.9315, 0.9325, true, 1024},
        {"farthest-point", "mean_nearest_distance", "0.9325", 0.93245, 0.93255, true, 4096},
        {"farthest-point", "effective_nyquist", "0.9", 0.85, 0.95},
        {"farthest-point", "oscillation", "4.6", 4.55, 4.65, false},
        {"gaussian-blue-noise", "low_frequency_mean", "at most 0.001", 0, 0.001},
        {"target-spectrum", "effective_nyquist", "at most 0.595", 0, 0.595},
        {"target-spectrum", "oscillation", "at most 0.105", 0, 0.105},
        {"target-spectrum", "mean_nearest_distance", "0.645", 0.6445, 0.6455, false, 4096},
        {"target-spectrum-target-single-peak-frequency-0.7", "effective_nyquist", "at most 0.86", 0, 0.86},
        {"equal-areas", "mean_nearest_distance", "0.896", 0.8955, 0.8965, false, 4096},
        {"equal-areas-i-20", "mean_nearest_distance", "0.896", 0.8955, 0.8965, true, 4096},
        {"corner-tiles-C-4-sets-10", "relative_radius", "at least 0.75", 0.75, no_limit},
        {"edge-tiles-C-2-repulsion-sets-10", "relative_radius", "at least 0.75", 0.75, no_limit},
        {"template-tiles-T-64-sets-10", "relative_radius", "at least 0.75", 0.75, no_limit},
        {"sphere-tiles-C-2-N-128-repulsion-3d", "relative_radius", "at least 0.75", 0.75, no_limit},
        {"averaged-tiles-sets-10", "relative_radius", "at most 0.40", 0, 0.405, false},
        {"recursive-wang-tiles-sets-10", "relative_radius", "at most 0.44", 0, 0.445, false},
        {"penrose-random_window", "relative_radius", "0.65 to 0.75", 0.65, 0.75},
        {"penrose-random_window", "mean_nearest_distance", "0.881", 0.8805, 0.8815, true, 4096},
    };
    return numbers;
}

/// A published number, and the gallery's.
struct Comparison
{
    const GalleryMethod& method;
    const PublishedNumber& published;
    Estimate ours;

    double error() const
    {
        const double own = ours.standard_error.value_or(published.error);
        if (published.points_of_one_set == 0) return own;
        // Deviations of means over a set's points fall with the root of their number.
        const double sets = method.curve.periodograms * static_cast<double>(method.curve.points);
        return own * std::sqrt(1 + sets / published.points_of_one_set);
    }

    bool agrees() const
    {
        return ours.value >= published.least - 5 * error() && ours.value <= published.most + 5 * error();
    }

    /// Zero within what the published words leave open.
    double difference() const { return ours.value - std::clamp(ours.value, published.least, published.most); }

    /// The row of the table without its last column.
    std::string row() const
    {
        const double spread = ours.standard_error.value_or(0);
        // Tilings all have the same distances, up to rounding.
        const std::string scatter = spread > 1e-9 ? fmt::format(" ± {}", spread) : "";
        return fmt::format("| `{}` | `{}` | {} | {}{} | {} | ", method.name, published.measure, published.words,
                           ours.value, scatter, agrees() ? "agrees" : fmt::format("{:+.2g}", difference()));
    }
};

/// Every published number beside the gallery's; one that the gallery lacks is a failure.
std::vector<Comparison> comparisons()
{
    std::vector<Comparison> all;
    for (const PublishedNumber& number : published_numbers()) {
        const auto method = std::ranges::find(reference_gallery(), number.method, &GalleryMethod::name);
        if (method == reference_gallery().end() || !method->measures.contains(number.measure))
            ADD_FAILURE() << number.method << " has no " << number.measure;
        else
            all.push_back({*method, number, method->measures.at(number.measure)});
    }
    return all;
}

TEST(PublishedNumbers, AreThoseOfTheGalleryUnlessTheTableSaysWhyNot)
{
    for (const Comparison& comparison : comparisons())
        EXPECT_EQ(comparison.agrees(), comparison.published.agrees) << comparison.row();
}

TEST(PublishedNumbers, StandInTheReadmeAsTheyAre)
{
    const std::string readme = content_of(source_folder() + "/docs/gallery/README.md");
    std::size_t rows = 0;
    for (const Comparison& comparison : comparisons()) {
        const std::size_t at = readme.find(comparison.row());
        EXPECT_NE(at, readme.npos) << "docs/gallery/README.md lacks the row\n" << comparison.row();
        if (at == readme.npos) continue;
        const std::string rest = readme.substr(at + comparison.row().size(), 40);
        EXPECT_GT(rest.find('|'), 5u) << comparison.row() << " needs its source";
        ++rows;
    }
    std::size_t lines = 0;
    for (std::size_t at = readme.find("\n| `"); at != readme.npos; at = readme.find("\n| `", at + 1)) ++lines;
    EXPECT_EQ(lines, rows + 3) << "other rows that begin with code are the three tables";
}

}
}
