// A point set of cySampleElim on the torus, in progressive order: POINTS SEED FILE. Writes a point a line.
//
// The program keeps one of five random points, as the laboratory's sampler does by default.

#include <cySampleElim.h>
#include <cyVector.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

int main(int count, char** arguments)
{
    if (count != 4) {
        std::fputs("sample_elimination POINTS SEED FILE\n", stderr);
        return 2;
    }
    const std::size_t points = std::strtoull(arguments[1], nullptr, 10);
    std::mt19937_64 random(std::strtoull(arguments[2], nullptr, 10));
    std::uniform_real_distribution<double> coordinate;
    std::vector<cy::Vec2d> candidates(5 * points), kept(points);
    for (cy::Vec2d& point : candidates) {
        point.x = coordinate(random);
        point.y = coordinate(random);
    }

    cy::WeightedSampleElimination<cy::Vec2d, double, 2> elimination;
    elimination.SetTiling();
    elimination.Eliminate(candidates.data(), candidates.size(), kept.data(), kept.size(), true);

    std::FILE* file = std::fopen(arguments[3], "w");
    if (!file) {
        std::perror(arguments[3]);
        return 1;
    }
    for (const cy::Vec2d& point : kept) std::fprintf(file, "%.17g %.17g\n", point.x, point.y);
    return std::fclose(file) == 0 ? 0 : 1;
}
