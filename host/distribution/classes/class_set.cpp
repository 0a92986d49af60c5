#include "host/distribution/classes/class_set.hpp"

#include "analysis/regions/region_transform.hpp"
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/classes/class_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

namespace poissonlab {
namespace {

/// Random labellings are left out if they would compare more pairs than this, since they would take far longer than all
/// other measures.
constexpr double most_comparisons = 5e8;

/// The spectra of all classes together have at most this many frequencies, of 16 bytes each.
constexpr double most_frequencies = 1 << 26;

PointDomain domain_of(const ClassSetSettings& s)
{
    const auto domain = parse_domain(s.domain);
    if (!domain) throw InputError(s.domain + ": must be " + domain_form);
    return *domain;
}

/// The rectangle of a domain, as a region.
std::string rectangle_of_domain(const PointDomain& domain)
{
    return fmt::format("rectangle {:.17g} {:.17g} {:.17g} {:.17g}", domain[0].low, domain[1].low, domain[0].high,
                       domain[1].high);
}

/// Coordinates in [0, 1) of a domain in its own units.
void unmap(PointSet& points, const PointDomain& domain)
{
    for (std::size_t i = 0; i < points.coordinates.size(); ++i) {
        const CoordinateRange& range = domain[i % 2];
        points.coordinates[i] = range.low + points.coordinates[i] * (range.high - range.low);
    }
}

PointSet one_plane_set(std::vector<PointSet> sets, const std::string& name)
{
    if (sets.size() != 1)
        throw InputError(
            fmt::format("{}: has {} sets; points with classes are measured one set at a time", name, sets.size()));
    if (sets.front().dimension != 2) throw InputError(name + ": points with classes are measured in the plane alone");
    return std::move(sets.front());
}

void put_on_torus(const ClassSetSettings& s, PointReading& how, ClassSetPoints& set)
{
    const std::string name = s.set.string();
    PointDomain domain;
    if (!s.domain.empty()) how.domain = domain_of(s);
    set.points = one_plane_set(read_points_in_box(s.set, how, domain), name);
    const std::vector<double> sides{domain[0].high - domain[0].low, domain[1].high - domain[1].low};
    if (s.window) {
        unmap(set.points, domain);
        set.region = std::make_shared<const FramedRegion>(read_region(rectangle_of_domain(domain)), "the window");
        set.points = set.region->framed(set.points, name);
        set.unit = set.region->side();
        return;
    }
    set.box = periodic_box(sides);
    set.unit = root_of_volume(sides);
}

void put_into_region(const ClassSetSettings& s, PointReading& how, ClassSetPoints& set)
{
    const PlaneRegion region = read_region(s.region, s.reading);
    set.region = std::make_shared<const FramedRegion>(region, name_of_input(s.region));
    how.domain = any_coordinates;
    how.degrees_sentence = degrees_sentence(region);
    const std::string name = s.set.string();
    set.points = set.region->framed(one_plane_set(read_points(s.set, how), name), name);
    set.unit = set.region->side();
    for (const std::string& note : notes_of(region)) set.notes.push_back(note);
}

/// The transforms of the classes, less that of the region.
std::vector<HalfPlane> planes_in_region(const std::vector<PointSet>& sets, const FramedRegion& region, int reach)
{
    NonuniformTransform transform(reach);
    const HalfPlane window = region_transforms(region, reach, transform);
    std::vector<HalfPlane> planes;
    for (const PointSet& set : sets) {
        HalfPlane& plane = planes.emplace_back(region_sums(set, {}, region.unit_length(), reach, &transform));
        for (std::size_t i = 0; i < plane.values.size(); ++i)
            plane.values[i] -= static_cast<double>(set.size()) * window.values[i];
    }
    return planes;
}

class ClassSetMeasurement
{
public:
    ClassSetMeasurement(const ClassSetPoints& set, const ClassSetSettings& settings)
        : set_(set), settings_(settings), sets_(set.by_class()),
          place_(set.region ? ClassPlace(set.region) : ClassPlace(set.box))
    {}

    ClassSetMeasures measure(const std::function<void(const std::string& what)>& on_step)
    {
        expect_pairs();
        ClassSetMeasures measures;
        for (std::size_t b = 0; b < sets_.size(); ++b)
            for (std::size_t a = 0; a <= b; ++a) {
                stop_if_interrupted();
                if (on_step) on_step(fmt::format("pairs of {} and {}", set_.names[a], set_.names[b]));
                (a == b ? measures.own : measures.cross).push_back(measure_pair(sets_[a], sets_[b], a, b));
            }
        stop_if_interrupted();
        if (on_step) on_step("pairs of all points");
        measures.all = measure_pair(set_.points, set_.points, 0, 0);
        const bool are_too_many = measures.all.pairs * settings_.labellings > most_comparisons;
        measures.labellings = are_too_many ? 0 : settings_.labellings;
        measures.marks = mark_correlation(set_.points, set_.classes, place_, measures.all.steps, measures.labellings);
        measures.spectra = spectra();
        measures.covariance_error = place_.covariance_error();
        return measures;
    }

private:
    ClassDistanceSteps steps_for(std::size_t points) const
    {
        return class_distance_steps(place_, points, settings_.reach.value_or(0) / set_.unit);
    }

    double pairs_within(const ClassDistanceSteps& steps, std::size_t a, std::size_t b) const
    {
        const double reach = steps.reach() + steps.half_width;
        return static_cast<double>(a) * static_cast<double>(b) *
               std::min(1.0, std::numbers::pi * reach * reach / place_.area());
    }

    /// All pairs need the covariance of the region: the two smallest classes have the longest distances.
    void expect_pairs()
    {
        double pairs = 0, longest = 0;
        const auto add = [&](std::size_t a, std::size_t b, std::size_t together) {
            const ClassDistanceSteps steps = steps_for(together);
            pairs += pairs_within(steps, a, b);
            longest = std::max(longest, steps.reach() + steps.half_width);
        };
        for (std::size_t b = 0; b < sets_.size(); ++b)
            for (std::size_t a = 0; a <= b; ++a) {
                const std::size_t n = sets_[a].size(), m = sets_[b].size();
                add(n, m, a == b ? n : n + m);
            }
        add(set_.points.size(), set_.points.size(), set_.points.size());
        place_.expect(pairs, longest);
    }

    ClassPairMeasures measure_pair(const PointSet& a, const PointSet& b, std::size_t first, std::size_t second) const
    {
        ClassPairMeasures pair;
        pair.first = first;
        pair.second = second;
        const bool is_same = &a == &b;
        const CrossNearest there = cross_nearest(a, b, place_);
        pair.least = there.least * set_.unit;
        pair.mean_first = there.mean * set_.unit;
        pair.mean_second = is_same ? pair.mean_first : cross_nearest(b, a, place_).mean * set_.unit;
        pair.steps = steps_for(is_same ? a.size() : a.size() + b.size());
        pair.values = class_pair_correlation(a, b, place_, pair.steps, &pair.pairs);
        return pair;
    }

    std::optional<CrossSpectra> spectra() const
    {
        if (!set_.region && !set_.box.is_unit()) return {};
        const double root = std::sqrt(static_cast<double>(set_.points.size()));
        const double most = std::min(1024.0, std::sqrt(most_frequencies / 2 / static_cast<double>(sets_.size())));
        const int reach = static_cast<int>(std::clamp(2.5 * root, 8.0, most));
        if (!set_.region) return cross_spectra(sets_, reach);
        std::vector<double> counts;
        for (const PointSet& set : sets_) counts.push_back(static_cast<double>(set.size()));
        return spectra_of_planes(planes_in_region(sets_, *set_.region, reach), counts);
    }

    const ClassSetPoints& set_;
    const ClassSetSettings& settings_;
    std::vector<PointSet> sets_;
    ClassPlace place_;
};

}

PointSet ClassSetPoints::of_class(std::size_t number) const
{
    PointSet some{2, {}};
    for (std::size_t i = 0; i < classes.size(); ++i)
        if (classes[i] == number) some.coordinates.insert(some.coordinates.end(), points[i].begin(), points[i].end());
    return some;
}

std::vector<PointSet> ClassSetPoints::by_class() const
{
    std::vector<PointSet> sets;
    for (std::size_t i = 0; i < names.size(); ++i) sets.push_back(of_class(i));
    return sets;
}

std::shared_ptr<const ClassSetPoints> read_class_set(const ClassSetSettings& settings)
{
    if (settings.read) return settings.read;
    ClassSetPoints set;
    std::vector<std::string> class_of_point;
    PointReading how;
    how.told = [&](const std::string& sentence) { set.notes.push_back(sentence); };
    how.classes = {settings.classes, [&](std::string_view name) { class_of_point.emplace_back(name); }};
    settings.region.empty() ? put_on_torus(settings, how, set) : put_into_region(settings, how, set);
    const std::string name = settings.set.string();
    if (class_of_point.size() != set.points.size())
        throw InputError(name + ": has no classes; only text, tables, PLY and GeoJSON can have them");
    std::tie(set.classes, set.names) = number_classes(class_of_point, name);
    return std::make_shared<const ClassSetPoints>(std::move(set));
}

ClassSetMeasures measure_class_set(const ClassSetPoints& set, const ClassSetSettings& settings,
                                   const std::function<void(const std::string& what)>& on_step)
{
    return ClassSetMeasurement(set, settings).measure(on_step);
}

}
