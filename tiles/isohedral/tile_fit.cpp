#include "tiles/isohedral/tile_fit.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// A motion's linear part: x becomes u x, or u times the conjugate of x.
struct LinearStep
{
    PlaneStep u{1, 0};
    bool is_mirrored = false;

    PlaneStep operator()(const PlaneStep& x) const { return u * (is_mirrored ? std::conj(x) : x); }
    LinearStep operator*(const LinearStep& first) const { return {(*this)(first.u), is_mirrored != first.is_mirrored}; }
    LinearStep inverse() const { return {is_mirrored ? u : std::conj(u), is_mirrored}; }
};

LinearStep linear_of(const PlaneMotion& motion, double sign)
{
    return {PlaneStep(motion.xx, motion.yx) * sign, motion.is_mirror()};
}

/// Steps of edge `to` are images of those of edge `from`, in the same order or not.
struct StepRelation
{
    std::size_t from, to;
    bool is_reversed;
    LinearStep linear;
};

std::vector<StepRelation> relations_of(const IsohedralTemplate& shape)
{
    std::vector<StepRelation> relations;
    const auto add = [&](const PlaneMotion& motion, std::size_t from, std::size_t to) { // chambers
        const bool is_reversed = (from + to) % 2 != 0;
        const LinearStep linear = linear_of(motion, is_reversed ? -1 : 1);
        relations.push_back({from / 2, to / 2, is_reversed, linear});
        relations.push_back({to / 2, from / 2, is_reversed, linear.inverse()});
    };
    for (std::size_t e = 0; e < shape.base.size(); ++e) add(shape.hops[e], shape.symbol.chamber_across(2 * e), 2 * e);
    for (std::size_t i = 0; i < shape.symmetries.size(); ++i)
        for (std::size_t e = 0; e < shape.base.size(); ++e)
            add(shape.symmetries[i], 2 * e, shape.symbol.symmetries[i][2 * e]);
    return relations;
}

/// The linear map z -> s z + t conj(z) with a real s, which is symmetric.
struct SymmetricStep
{
    double s = 0;
    PlaneStep t;

    PlaneStep operator()(const PlaneStep& z) const { return s * z + t * std::conj(z); }

    /// The inverse on what the map reaches, 0 across it; `size` is that of s where nothing is small.
    SymmetricStep pseudo_inverse(double size) const
    {
        constexpr double small = 1e-9;
        if (s < small * size) return {};
        if (s - std::abs(t) < small * s) return {1 / (4 * s), t / (4 * s * s)}; // one direction alone
        const double determinant = s * s - std::norm(t);
        return {s / determinant, -t / determinant};
    }
};

PlanePoint point_of(const PlaneStep& z) { return {z.real(), z.imag()}; }
PlaneStep step_of(const PlanePoint& p) { return {p[0], p[1]}; }

/// The curve whose shape an edge with this curve has: see shaped_curve().
PlaneCurve drawn_part(const PlaneCurve& curve, EdgeShape shape)
{
    if (shape == EdgeShape::straight) return {{0, 0}, {1, 0}};
    if (shape == EdgeShape::free) return curve;
    const std::size_t steps = curve.size() - 1;
    PlaneCurve part;
    for (std::size_t i = 0; 2 * i < steps; ++i)
        part.push_back({2 * curve[i][0], shape == EdgeShape::turned ? 2 * curve[i][1] : curve[i][1]});
    // The middle lies on the edge, or half way along a step across the mirror.
    const double height = steps % 2 == 0 ? curve[steps / 2][1] : (curve[steps / 2][1] + curve[steps / 2 + 1][1]) / 2;
    part.push_back({1, shape == EdgeShape::turned ? 0 : height});
    return part;
}

}

TileFit::TileFit(const IsohedralType& type) : type_(&type)
{
    find_uses();
    for (const auto& uses : uses_) {
        std::vector<bool> has(type.shape.base.size());
        for (const Use& use : uses) has[use.edge] = true;
        edges_.push_back(static_cast<std::size_t>(std::ranges::count(has, true)));
        const double ways = static_cast<double>(uses.size()) / static_cast<double>(edges_.back());
        std::array<PlaneStep, 2> closing{};
        for (const Use& use : uses) closing[use.is_mirrored] += use.u / ways;
        closing_.push_back(closing);
    }
}

void TileFit::find_uses()
{
    const IsohedralTemplate& shape = type_->shape;
    const std::vector<StepRelation> relations = relations_of(shape);
    uses_.resize(shape.curve_shapes.size());
    for (std::size_t curve = 0; curve < uses_.size(); ++curve) {
        const auto first = std::ranges::find(shape.edge_curves, curve, &EdgeCurve::curve);
        std::vector<Use>& uses = uses_[curve];
        uses.push_back({static_cast<std::size_t>(first - shape.edge_curves.begin()), false, false, {1, 0}});
        for (std::size_t i = 0; i < uses.size(); ++i)
            for (const StepRelation& relation : relations) {
                if (relation.from != uses[i].edge) continue;
                const LinearStep linear = relation.linear * LinearStep{uses[i].u, uses[i].is_mirrored};
                const Use next{relation.to, uses[i].is_reversed != relation.is_reversed, linear.is_mirrored, linear.u};
                const bool is_known = std::ranges::any_of(uses, [&](const Use& use) {
                    return use.edge == next.edge && use.is_reversed == next.is_reversed &&
                           use.is_mirrored == next.is_mirrored && std::abs(use.u - next.u) < 1e-6;
                });
                if (!is_known) uses.push_back(next);
            }
        for (const Use& use : uses) has_mirrors_ = has_mirrors_ || use.is_mirrored;
    }
}

/// Means over equal steps, and what the best rotation and closing follow from. For a goal rotated by an angle, a step
/// of a curve is exp(i angle) mean[0] + exp(-i angle) mean[1].
struct TileFit::Sums
{
    std::array<std::size_t, 7> first{}; ///< of the steps of each edge
    std::vector<std::array<PlaneStep, 2>> means{};
    std::array<double, 6> weights{}; ///< of each curve
    double squares = 0;              ///< of means, the part that no rotation changes
    PlaneStep twice{};               ///< the part that changes, by the real part of its product with exp(2 i angle)
    std::array<PlaneStep, 2> gap{};  ///< from the outline's end to its start, as means
    SymmetricStep closing{};         ///< what a pull at the end does to the gap
    double size = 0;                 ///< of a pull that meets no resistance
};

/// The rotation of the goal that is best, and the closing of the outline then.
struct TileFit::Rotation
{
    double likeness = 0, angle = 0;
    PlaneStep turn{}, pull{};

    explicit Rotation(const Sums& sums)
    {
        const SymmetricStep opening = sums.closing.pseudo_inverse(sums.size);
        const auto& [g, h] = sums.gap;
        const PlaneStep t = std::conj(opening.t);
        const double lost = opening.s * (std::norm(g) + std::norm(h)) + 2 * std::real(t * g * h);
        const PlaneStep twice = sums.twice - (2 * opening.s * g * std::conj(h) + t * g * g + std::conj(t * h * h));
        likeness = sums.squares - lost + std::abs(twice);
        angle = std::abs(twice) > 0 ? -std::arg(twice) / 2 : 0;
        turn = std::polar(1.0, angle);
        pull = opening(turn * g + std::conj(turn) * h);
    }
};

void TileFit::add_curve(Sums& sums, const GoalSteps& goal, std::size_t curve, bool keeps_means) const
{
    const auto& uses = uses_[curve];
    const std::size_t pieces = goal.pieces[curve];
    double all = 0;
    for (const Use& use : uses) all += goal.weights[use.edge];
    const double weight = all * static_cast<double>(edges_[curve]) / static_cast<double>(uses.size());
    std::array<PlaneStep, 2> whole{};
    for (std::size_t i = 0; i < pieces; ++i) {
        std::array<PlaneStep, 2> x{};
        for (const Use& use : uses) {
            const PlaneStep& w = goal.steps[sums.first[use.edge] + (use.is_reversed ? pieces - 1 - i : i)];
            const double share = goal.weights[use.edge] / all, c = share * use.u.real(), s = share * use.u.imag();
            // conj(u) w, or u conj(w)
            const double re = c * w.real() + s * w.imag(), im = c * w.imag() - s * w.real();
            if (use.is_mirrored)
                x[1] += PlaneStep(re, -im);
            else
                x[0] += PlaneStep(re, im);
        }
        sums.squares += weight * (std::norm(x[0]) + std::norm(x[1]));
        if (has_mirrors_) sums.twice += 2 * weight * x[0] * std::conj(x[1]);
        for (const std::size_t k : {0, 1}) whole[k] += x[k];
        if (keeps_means) sums.means.push_back(x);
    }
    const auto& [a, b] = closing_[curve];
    const double part = static_cast<double>(pieces) / weight;
    sums.weights[curve] = weight;
    sums.gap[0] += a * whole[0] + b * std::conj(whole[1]);
    sums.gap[1] += a * whole[1] + b * std::conj(whole[0]);
    sums.closing.s += part * (std::norm(a) + std::norm(b));
    sums.closing.t += 2 * part * a * b;
    sums.size += part;
}

TileFit::Sums TileFit::sums_of(const GoalSteps& goal, bool keeps_means) const
{
    Sums sums;
    for (std::size_t e = 0; e < type_->shape.base.size(); ++e)
        sums.first[e + 1] = sums.first[e] + goal.pieces[type_->shape.edge_curves[e].curve];
    for (std::size_t curve = 0; curve < uses_.size(); ++curve) add_curve(sums, goal, curve, keeps_means);
    return sums;
}

std::vector<PlaneStep> TileFit::steps_of(const Sums& sums, const Rotation& rotation,
                                         const std::vector<std::size_t>& pieces) const
{
    std::vector<PlaneStep> steps(sums.first[type_->shape.base.size()]);
    auto mean = sums.means.begin();
    for (std::size_t curve = 0; curve < uses_.size(); ++curve) {
        const auto& [a, b] = closing_[curve];
        const PlaneStep back = (std::conj(a) * rotation.pull + b * std::conj(rotation.pull)) / sums.weights[curve];
        for (std::size_t i = 0; i < pieces[curve]; ++i, ++mean) {
            const PlaneStep x = rotation.turn * (*mean)[0] + std::conj(rotation.turn) * (*mean)[1] - back;
            for (const Use& use : uses_[curve])
                steps[sums.first[use.edge] + (use.is_reversed ? pieces[curve] - 1 - i : i)] =
                    LinearStep{use.u, use.is_mirrored}(x);
        }
    }
    return steps;
}

double TileFit::likeness(const GoalSteps& goal) const { return Rotation(sums_of(goal, false)).likeness; }

TileFit::Nearest TileFit::nearest(const GoalSteps& goal) const
{
    const Sums sums = sums_of(goal, true);
    const Rotation rotation(sums);
    const std::vector<PlaneStep> steps = steps_of(sums, rotation, goal.pieces);
    Nearest tile{rotation.likeness, rotation.angle, {}, {}};
    PlaneStep at{};
    for (const PlaneStep& step : steps) {
        tile.outline.push_back(point_of(at));
        at += step;
    }
    set_parameters(tile, goal.pieces);
    return tile;
}

void TileFit::set_parameters(Nearest& tile, const std::vector<std::size_t>& pieces) const
{
    const IsohedralTemplate& shape = type_->shape;
    auto& outline = tile.outline;
    std::vector<std::size_t> first{0};
    for (const EdgeCurve& edge : shape.edge_curves) first.push_back(first.back() + pieces[edge.curve]);
    // Parameters count from the Laves tile: its middle, its size, and where there are no mirrors its direction as well.
    PlaneStep middle{}, scale{};
    double square = 0;
    for (std::size_t e = 0; e < shape.base.size(); ++e) {
        const PlaneStep corner = step_of(outline[first[e]]), base = step_of(shape.base[e]);
        middle += corner / static_cast<double>(shape.base.size());
        scale += corner * std::conj(base); // whose sum is 0
        square += std::norm(base);
    }
    scale = (has_mirrors_ ? scale.real() : scale) / square;
    for (PlanePoint& p : outline) p = point_of((step_of(p) - middle) / scale);
    const auto place = [&](std::size_t i) { return step_of(outline[i % outline.size()]); };
    for (const auto& deformation : shape.deformations) {
        double parameter = 0;
        for (std::size_t e = 0; e < shape.base.size(); ++e)
            parameter += std::real(place(first[e]) * std::conj(step_of(deformation[e])));
        tile.parameters.deformations.push_back(parameter);
    }
    for (std::size_t curve = 0; curve < shape.curve_shapes.size(); ++curve) {
        const std::size_t from = first[uses_[curve][0].edge], to = from + pieces[curve];
        PlaneCurve points{{0, 0}};
        for (std::size_t i = from + 1; i < to; ++i)
            points.push_back(point_of((place(i) - place(from)) / (place(to) - place(from))));
        points.push_back({1, 0});
        tile.parameters.curves.push_back(drawn_part(points, shape.curve_shapes[curve]));
    }
}

}
