// Headers of NumPy files, against the bytes that numpy.save() wrote.
#include "base/files/npy_header.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(NpyHeader, IsThatOfNumpy)
{
    // numpy.save(file, numpy.zeros((3, 2), "u1")), but for the numbers.
    const std::string text = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 2), }";
    const std::string expected =
        std::string("\x93NUMPY\x01\x00\x76\x00", 10) + text + std::string(118 - text.size() - 1, ' ') + "\n";
    EXPECT_EQ(npy_header_of("'|u1'", "(3, 2)"), expected);
    EXPECT_EQ(expected.size() % 64, 0U);
}

}
}
