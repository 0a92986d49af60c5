// SPDX-License-Identifier: MIT-0
//
// Points from a tile set file: those in a window as text, and the one that is nearest to the window's middle.
//
//   poisson_tiles_example FILE X Y W H [DENSITY]     (in 3D the window is one tile deep)
#include "poisson_tiles.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv)
{
    if (argc != 6 && argc != 7) return std::fprintf(stderr, "usage: %s FILE X Y W H [DENSITY]\n", argv[0]), 2;
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};

    ptiles_tiling tiling = {{}, 1, 0}; // the seed, and no period
    if (const char* problem = ptiles_open(&tiling.set, bytes.data(), bytes.size()))
        return std::fprintf(stderr, "%s: %s\n", argv[1], problem), 2;

    const double low[] = {std::atof(argv[2]), std::atof(argv[3]), 0};
    const double high[] = {low[0] + std::atof(argv[4]), low[1] + std::atof(argv[5]), 1};
    const double density = argc == 7 ? std::atof(argv[6]) : 1; // the part of the points that is wanted
    std::vector<ptiles_point> points(ptiles_in_window(&tiling, low, high, nullptr, 0, density)); // how many there are
    ptiles_in_window(&tiling, low, high, points.data(), points.size(), density);
    for (const ptiles_point& p : points) std::printf("%.9g %.9g %.9g\n", p.position[0], p.position[1], p.position[2]);

    const double middle[] = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0.5};
    ptiles_point p;
    ptiles_nearest(&tiling, middle, &p);
    std::printf("# nearest to %g %g: %.9g %.9g, number %u of the tile (%d, %d), id %08x\n", middle[0], middle[1],
                p.position[0], p.position[1], p.index, p.tile[0], p.tile[1], p.id);
}
