// Rings of roots of unity, against complex numbers, and numbers of them as people write them.
#include "tiles/prototiles/ring_expression.hpp"
#include "tiles/prototiles/root_ring.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <limits>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

Complex complex_value(const RootRing& ring, const RingPlace& place)
{
    Complex sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += static_cast<double>(place.c[static_cast<std::size_t>(i)]) *
               std::polar(1.0, 2 * std::numbers::pi * i / ring.order());
    return sum;
}

TEST(RootRing, ComputesAsComplexNumbersDo)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> integer(-20, 20);
    const auto place = [&] { return RingPlace{{integer(random), integer(random), integer(random), integer(random)}}; };
    for (const int order : {8, 10, 12}) {
        const RootRing ring(order);
        for (int i = 0; i < 200; ++i) {
            const RingPlace a = place(), b = place();
            const Complex x = complex_value(ring, a), y = complex_value(ring, b);
            EXPECT_NEAR(std::abs(complex_value(ring, ring.times(a, b)) - x * y), 0, 1e-9) << order;
            EXPECT_NEAR(std::abs(complex_value(ring, ring.conjugate(a)) - std::conj(x)), 0, 1e-9) << order;
            EXPECT_NEAR(ring.value(a)[0], x.real(), 1e-9);
            EXPECT_NEAR(ring.value(a)[1], x.imag(), 1e-9);
            EXPECT_NEAR(ring.sizes(a)[0], std::abs(x), 1e-9);
            const auto largest = std::ranges::max(a.c, {}, [](std::int64_t c) { return std::abs(c); });
            EXPECT_LE(std::abs(largest), 2 * std::max(ring.sizes(a)[0], ring.sizes(a)[1]) + 1e-9) << order;
        }
        for (int k = -30; k <= 30; ++k)
            EXPECT_NEAR(
                std::abs(complex_value(ring, ring.unit(k)) - std::polar(1.0, 2 * std::numbers::pi * k / ring.order())),
                0, 1e-12);
    }
}

TEST(RootRing, RefusesWhatNeedsMoreThan64Bits)
{
    const RootRing ring(10);
    const RingPlace large{{std::int64_t{1} << 40, 0, 0, 0}};
    EXPECT_EQ(ring.times(large, {{1 << 20, 0, 0, 0}}).c[0], std::int64_t{1} << 60);
    EXPECT_THROW(ring.times(large, large), InputError);
}

TEST(RingExpression, ReadsSumsProductsAndDirections)
{
    const RootRing ten(10), twelve(12), eight(8);
    const double phi = std::numbers::phi;
    const auto close = [](const RootRing& ring, const char* text, const Complex& value) {
        EXPECT_NEAR(std::abs(complex_value(ring, ring_expression(ring, text)) - value), 0, 1e-12) << text;
    };
    const auto at = [](double degrees) { return std::polar(1.0, degrees * std::numbers::pi / 180); };
    close(ten, "phi phi@36", phi * phi * at(36));
    close(ten, "1 + 2phi - @72", 1 + 2 * phi - at(72));
    close(twelve, "(2 + sqrt3) @30", (2 + std::numbers::sqrt3) * at(30));
    close(twelve, "-(1 - 3 i) * 2", Complex(-2, 6));
    close(twelve, "-@-60+i", -at(-60) + Complex(0, 1));
    close(eight, "sqrt2@45", Complex(1, 1));
    close(eight, " + 7 ", 7);
}

TEST(RingExpression, SaysWhatIsWrong)
{
    const RootRing ring(10);
    const std::vector<std::pair<const char*, const char*>> cases{
        {"", "ends too early"},
        {"1 +", "ends too early"},
        {"@30", "@30: degrees must be multiples of 36 here"},
        {"sqrt3", "\"sqrt3\" is not a number of 10 directions; known: phi, @36"},
        {"(1", "lacks a )"},
        {"1)", "\")\" is not expected"},
        {"1 % 2", "has a \"%\""},
        {"99999999999", "must have an integer from 0 to 1000000 at \"99999999999\""},
        {"1000000 1000000 1000000", "is too large"}};
    for (const auto& [text, problem] : cases)
        EXPECT_EQ(message_of([&, t = text] { ring_expression(ring, t); }), problem) << text;
}

}
}
