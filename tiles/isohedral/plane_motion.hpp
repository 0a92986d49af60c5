// Motions of the plane: rotations, reflections, translations and what they make together.
#pragma once

#include <array>
#include <cmath>

namespace poissonlab {

using PlanePoint = std::array<double, 2>;

/// A point p goes to (xx p.x + xy p.y + x, yx p.x + yy p.y + y).
struct PlaneMotion
{
    double xx = 1, xy = 0, yx = 0, yy = 1;
    double x = 0, y = 0;

    PlanePoint linear(const PlanePoint& p) const { return {xx * p[0] + xy * p[1], yx * p[0] + yy * p[1]}; }
    PlanePoint operator()(const PlanePoint& p) const
    {
        const PlanePoint q = linear(p);
        return {q[0] + x, q[1] + y};
    }

    /// The product moves by `second` first, then by this motion.
    PlaneMotion operator*(const PlaneMotion& second) const
    {
        const PlanePoint moved = (*this)({second.x, second.y});
        return {xx * second.xx + xy * second.yx,
                xx * second.xy + xy * second.yy,
                yx * second.xx + yy * second.yx,
                yx * second.xy + yy * second.yy,
                moved[0],
                moved[1]};
    }

    bool is_mirror() const { return xx * yy - xy * yx < 0; }
};

/// The motion's inverse, as the linear part is orthogonal.
inline PlaneMotion inverse(const PlaneMotion& m)
{
    return {m.xx, m.yx, m.xy, m.yy, -(m.xx * m.x + m.yx * m.y), -(m.xy * m.x + m.yy * m.y)};
}

inline bool same_linear_part(const PlaneMotion& a, const PlaneMotion& b)
{
    constexpr double close = 1e-6; // linear parts of one tiling differ by far more, or by rounding
    return std::abs(a.xx - b.xx) + std::abs(a.xy - b.xy) + std::abs(a.yx - b.yx) + std::abs(a.yy - b.yy) < close;
}

}
