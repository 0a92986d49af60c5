#include "host/scenes/construction_panels.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <fmt/format.h>

#include <optional>

namespace poissonlab {
namespace {

using Dart = TorusPoint<2>;

constexpr std::uint64_t most_failures = 10'000; ///< of dart throwing in a row
constexpr std::uint64_t shown_failures = 2;     ///< between two points

TilePosition unit_position(const Dart& dart)
{
    return {static_cast<std::int32_t>(dart[0] >> 16), static_cast<std::int32_t>(dart[1] >> 16), 0};
}

TilePosition unit_position(std::span<const double> point)
{
    return {static_cast<std::int32_t>(point[0] * tile_units), static_cast<std::int32_t>(point[1] * tile_units), 0};
}

ScenePanel set_panel(const std::string& caption, double radius)
{
    ScenePanel panel;
    panel.caption = caption;
    panel.radius = radius * tile_units;
    panel.window.size = {tile_units, tile_units, 0};
    panel.part = panel.window;
    panel.tiles = {{0, 0, 0}};
    return panel;
}

/// Dart number `i` of a stream, in 2D: see relaxation_dart_throwing.hpp.
Dart dart_of(const StreamKey& stream, std::uint64_t i)
{
    const auto words =
        philox({static_cast<std::uint32_t>(i / 2), static_cast<std::uint32_t>(i / 2 >> 32), 0, 0}, stream);
    return {words[i % 2 * 2], words[i % 2 * 2 + 1]};
}

/// Throws darts and makes the panels.
class DartSteps
{
public:
    DartSteps(const RelaxationDartThrowingRequest& request, bool relaxes) : request_(request), relaxes_(relaxes) {}

    std::vector<ScenePanel> make()
    {
        panels_.push_back(set_panel("There is no point yet.", levels_.radius()));
        while (points_.size() < request_.points && (relaxes_ || failures_ < most_failures)) {
            const Dart dart = dart_of(request_.stream, darts_++);
            if (const auto near = nearest_conflict(dart))
                fail(dart, *near);
            else
                accept(dart);
        }
        if (points_.size() < request_.points)
            add("Ten thousand darts in a row were refused: there is hardly any place left.");
        return std::move(panels_);
    }

private:
    /// The nearest of the points that are too near.
    std::optional<std::size_t> nearest_conflict(const Dart& dart) const
    {
        std::optional<std::size_t> found;
        std::uint64_t least = levels_.squared_min_distance();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const std::uint64_t squared = squared_distance<2>(points_[i], dart);
            if (squared >= least) continue;
            least = squared;
            found = i;
        }
        return found;
    }

    void accept(const Dart& dart)
    {
        const std::uint64_t hidden =
            failures_since_point_ > shown_failures ? failures_since_point_ - shown_failures : 0;
        ScenePanel& panel =
            add(fmt::format("Dart {} becomes point {}{}.", darts_, points_.size() + 1,
                            hidden > 0 ? fmt::format(", after {} more that were refused", hidden) : ""));
        panel.of(PointClass::inner).push_back(unit_position(dart));
        points_.push_back(dart);
        failures_ = failures_since_point_ = 0;
    }

    void fail(const Dart& dart, std::size_t near)
    {
        ++failures_;
        if (++failures_since_point_ <= shown_failures) {
            ScenePanel& panel = add(fmt::format("Dart {} is too near to point {}: refused.", darts_, near + 1));
            auto& held = panel.of(PointClass::held);
            panel.of(PointClass::inner).push_back(held[near]);
            held.erase(held.begin() + static_cast<std::ptrdiff_t>(near));
            panel.of(PointClass::outer).push_back(unit_position(dart));
        }
        if (!relaxes_ || failures_ < request_.attempts) return;
        failures_ = 0;
        levels_.reduce();
        add(fmt::format("{} darts in a row were refused: the radius shrinks to {:.4f}.", request_.attempts,
                        levels_.radius()));
    }

    /// A panel with all points so far. Radii that shrink one after the other share one.
    ScenePanel& add(const std::string& caption)
    {
        const bool shrinks_again = relaxes_ && failures_ == 0 && failures_since_point_ > shown_failures &&
                                   caption.find("shrinks") != std::string::npos &&
                                   panels_.back().caption.find("shrinks") != std::string::npos;
        if (shrinks_again) panels_.pop_back();
        panels_.push_back(set_panel(caption, levels_.radius()));
        for (const Dart& point : points_) panels_.back().of(PointClass::held).push_back(unit_position(point));
        return panels_.back();
    }

    RelaxationDartThrowingRequest request_;
    bool relaxes_;
    RadiusLevels levels_{request_};
    std::vector<Dart> points_;
    std::uint64_t darts_ = 0, failures_ = 0, failures_since_point_ = 0;
    std::vector<ScenePanel> panels_;
};

std::vector<ScenePanel> lloyd_steps(std::size_t count, std::uint32_t iterations, std::uint64_t seed)
{
    std::vector<Dart> random;
    const StreamKey stream = stream_key(seed, Purpose::random_points, 0);
    for (std::uint64_t i = 0; i < count; ++i) random.push_back(dart_of(stream, i));
    PointSet points = to_point_set<2>(random);
    std::vector<ScenePanel> panels;
    for (std::uint32_t i = 0;; ++i) {
        const LloydResult next = reference::relax(points, {}, {.iterations = 1});
        const double radius = next.iterations.front().relative_radius;
        ScenePanel panel = set_panel(
            fmt::format("{}: relative radius {:.3f}.",
                        i == 0 ? "Random points" : fmt::format("After {} iteration{}", i, i == 1 ? "" : "s"), radius),
            max_min_distance(count, 2) * radius / 2);
        for (std::size_t k = 0; k < points.size(); ++k) panel.of(PointClass::inner).push_back(unit_position(points[k]));
        panels.push_back(std::move(panel));
        if (i == iterations) return panels;
        points = next.points;
    }
}

std::vector<ScenePanel> steps_of(const ShownConstruction& config)
{
    const PoissonTileParameters& p = config.parameters;
    if (config.show == "lloyd") return lloyd_steps(p.points_per_tile, p.lloyd_iterations, p.seed);
    RelaxationDartThrowingRequest request;
    request.points = p.points_per_tile;
    request.attempts = p.attempts;
    request.factor = p.factor;
    request.stream = stream_key(p.seed, Purpose::relaxation_dart_throwing, 0);
    const bool relaxes = config.show == "relaxation-dart-throwing";
    if (!relaxes) request.initial_radius = min_distance_for(p.relative_radius, request.points, 2) / 2;
    return DartSteps(request, relaxes).make();
}

}

Scene set_scene(const ShownConstruction& config)
{
    Scene scene;
    scene.panels = steps_of(config);
    scene.width = 1; // there are no regions
    scene.columns = 3;
    scene.radius = std::max(scene.panels.back().radius, 1.0);
    return scene;
}

}
