// Directions in the plane without a library: cosine and sine of an angle, and the angle of a vector. Kernels and host
// code share it, so that devices and plain twins have the same bytes: libraries differ in last bits.
//
// Every operation is rounded exactly and none is contracted. Polynomials are Taylor's, of degrees whose next terms are
// below 2^-60. Bounds of errors, which tests hold against a library of higher precision:
//   unit_vector   2^-52 for angles of at most 64
//   direction_of  2^-50: half of it comes from subtracting from a half turn
#pragma once

#include "kernels/common/contract.h"

#ifdef __cplusplus
#include <cmath>
#define DIRECTION_FUNCTION inline
#else
#define DIRECTION_FUNCTION static inline
#endif

CONTRACT(directions)

REAL(HALF_TURN, 3.141592653589793)
REAL(QUARTER_TURN, 1.5707963267948966)
REAL(TWELFTH_TURN, 0.5235987755982989)
REAL(FIRST_BITS_OF_QUARTER, 0x1.921fb544p+0)        ///< 33 of them, so that small multiples are exact
REAL(OTHER_BITS_OF_QUARTER, 0x1.0b4611a626331p-34)
REAL(TANGENT_OF_HALF_TWELFTH, 0.2679491924311227)
REAL(ROOT_OF_3, 1.7320508075688772)

struct UnitVector
{
    double x, y;
};

/// Cosine and sine of an angle. It is brought to an eighth of a turn around zero by quarters of a turn.
DIRECTION_FUNCTION struct UnitVector unit_vector(double angle)
{
#ifdef __cplusplus
    using std::floor;
#endif
    const double quarters = floor(angle * 0.6366197723675814 + 0.5);
    const double a = (angle - quarters * FIRST_BITS_OF_QUARTER) - quarters * OTHER_BITS_OF_QUARTER;
    const double b = a * a;
    double sine = 1.0 / 355687428096000;
    sine = sine * b - 1.0 / 1307674368000;
    sine = sine * b + 1.0 / 6227020800;
    sine = sine * b - 1.0 / 39916800;
    sine = sine * b + 1.0 / 362880;
    sine = sine * b - 1.0 / 5040;
    sine = sine * b + 1.0 / 120;
    sine = sine * b - 1.0 / 6;
    sine = a + a * (sine * b);
    double cosine = 1.0 / 20922789888000;
    cosine = cosine * b - 1.0 / 87178291200;
    cosine = cosine * b + 1.0 / 479001600;
    cosine = cosine * b - 1.0 / 3628800;
    cosine = cosine * b + 1.0 / 40320;
    cosine = cosine * b - 1.0 / 720;
    cosine = cosine * b + 1.0 / 24;
    cosine = cosine * b - 0.5;
    cosine = 1 + cosine * b;
    const int turn = (int)quarters & 3;
    struct UnitVector vector;
    vector.x = turn & 1 ? sine : cosine;
    vector.y = turn & 1 ? cosine : sine;
    if (turn == 1 || turn == 2) vector.x = -vector.x;
    if (turn & 2) vector.y = -vector.y;
    return vector;
}

/// The angle of a vector, from minus to plus half a turn; 0 of the vector 0. Quotients below the tangent of a 24th of a
/// turn are left, after a 12th of a turn was taken from larger ones.
DIRECTION_FUNCTION double direction_of(double x, double y)
{
    const double width = x < 0 ? -x : x;
    const double height = y < 0 ? -y : y;
    const bool is_steep = height > width;
    const double longer = is_steep ? height : width;
    const double shorter = is_steep ? width : height;
    if (longer == 0) return 0;
    const bool is_turned = shorter > TANGENT_OF_HALF_TWELFTH * longer;
    const double t = (is_turned ? shorter * ROOT_OF_3 - longer : shorter) /
                     (is_turned ? longer * ROOT_OF_3 + shorter : longer);
    const double b = t * t;
    double sum = 1.0 / 29;
    sum = sum * b - 1.0 / 27;
    sum = sum * b + 1.0 / 25;
    sum = sum * b - 1.0 / 23;
    sum = sum * b + 1.0 / 21;
    sum = sum * b - 1.0 / 19;
    sum = sum * b + 1.0 / 17;
    sum = sum * b - 1.0 / 15;
    sum = sum * b + 1.0 / 13;
    sum = sum * b - 1.0 / 11;
    sum = sum * b + 1.0 / 9;
    sum = sum * b - 1.0 / 7;
    sum = sum * b + 1.0 / 5;
    sum = sum * b - 1.0 / 3;
    double angle = t + t * (sum * b);
    if (is_turned) angle = TWELFTH_TURN + angle;
    if (is_steep) angle = QUARTER_TURN - angle;
    if (x < 0) angle = HALF_TURN - angle;
    return y < 0 ? -angle : angle;
}

END_CONTRACT
