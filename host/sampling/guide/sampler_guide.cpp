#include "host/sampling/guide/sampler_guide.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace poissonlab {
namespace {

constexpr const char* dissertation = "Lagae, Tile-Based Methods in Computer Graphics, 2007";

std::vector<SamplerGuide> guides_without_disks()
{
    return {
        {"random", "A Poisson process: any textbook on stochastic geometry.",
         "The baseline: its power is 1 at every frequency, so every other curve is read against it.",
         "Points clump and leave holes. For sampling, every other method here has smaller errors."},
        {"regular", "A square lattice.", "To see aliasing, and as the start of methods that move points.",
         "Whatever is sampled shows patterns that are not there. Jittered points cost as little and have none."},
        {"jittered", "Cook, Stochastic Sampling in Computer Graphics, 1986.",
         "Where points must cost next to nothing and the number of points is a square (3D: a cube).",
         "Points of neighbouring cells can meet, so there is no minimum distance: take dart throwing or tiles."},
        {"hexagonal", "The densest packing of disks (Thue) and of spheres (Hales 2005).",
         "The upper reference: its relative radius is 1, and nothing is denser.",
         "It is a lattice, with peaks in few directions. Farthest points come near it without rows."},
        {"sobol", "Sobol 1967; nested scrambling by Owen 1995.",
         "For integrals of smooth functions: errors fall faster than those of any disk distribution.",
         "Points come near each other, and 2D spectra have directions. For looks, take blue noise."},
        {"halton", "Halton 1960; scrambling by Owen 1995.",
         "For integrals where the number of points is not a power of two.",
         "Where N is a power of two, Sobol points are as cheap and more even."},
        {"file", "Point files of any program.",
         "For sets that are there already: they are measured as every other series is, beside others.",
         "For a program that can be run, `command` makes new realizations for each experiment."},
        {"command", "Any program that writes points.",
         "To compare a method of your own, in any language, with all others and with errors.",
         "Programs run with your rights: read the configs of others first. Times include the start of the program."},
    };
}

std::vector<SamplerGuide> guides_to_darts()
{
    return {
        {"best-candidate", "Mitchell, Spectrally Optimal Sampling for Distribution Ray Tracing, 1991.",
         "For a few hundred points that come in a progressive order, in a few lines of code.",
         "Its relative radius stays below 0.5, and time grows faster than the number of points. Sample elimination is "
         "progressive as well, with 0.69."},
        {"bridson", "Bridson, Fast Poisson Disk Sampling in Arbitrary Dimensions, 2007.",
         "What games and libraries mostly use: here to be compared with it.",
         "Pieces that are made apart do not fit together. Tiles give endless points that do."},
        {"dart-throwing", "Cook 1986; maximal sets: random sequential addition, Zhang and Torquato 2013.",
         "The reference of blue noise: no bias, no direction, a minimum distance that is exact; with `stop = "
         "\"saturation\"` no room is left.",
         "It cannot pass a relative radius of 0.7767 (3D: 0.8035), and its power at low frequencies stays at some "
         "0.06. "
         "Sets that are relaxed or optimized go below."},
        {"relaxation-dart-throwing", "McCool and Fiume, Hierarchical Poisson Disk Sampling Distributions, 1992.",
         "For a set whose first points are a good, smaller set: levels of detail, progressive sampling.",
         "Its relative radius stays below that of dart throwing. Sample elimination has better first parts."},
        {"voronoi-darts", "Jones, Efficient Generation of Poisson-Disk Sampling Patterns, 2006.",
         "Dart throwing that never throws in vain, since it draws from what is left of the area.",
         "Time grows faster than the number of points, and it is for the plane. `dart-throwing` has sets of the same "
         "distribution, in space as well."},
        {"sector-darts",
         "Dunbar and Humphreys, A Spatial Data Structure for Fast Poisson-Disk Sample Generation, 2006.",
         "For saturated sets of a given distance; the boundary variant packs densest of all darts.",
         "The linear and the boundary variant are no dart throwing: their spectra have larger peaks."},
    };
}

std::vector<SamplerGuide> guides_to_optimized_sets()
{
    return {
        {"lloyd", "Lloyd 1982; McCool and Fiume 1992.",
         "For even points in a few seconds; with `repulsion` for a relative radius of 0.85.",
         "It gets stuck at a relative radius of 0.75 to 0.8, and long waves of its start remain. Equal areas and "
         "Gaussian "
         "blue noise have less power at low frequencies."},
        {"sample-elimination", "Yuksel, Sample Elimination for Generating Poisson Disk Sample Sets, 2015.",
         "For sets in an order whose every first part is a good set, up to millions of points, in 2D and 3D.",
         "Its radius is that of dart throwing. Where no order is needed, optimized sets are more even."},
        {"farthest-point", "Schlömer, Heck and Deussen, Farthest-Point Optimized Point Sets, 2011.",
         "For the largest minimum distance without rows or directions: a relative radius of 0.925.",
         "Its spectrum goes on in waves, so aliases have a frequency of their own. In space it is not there."},
        {"gaussian-blue-noise", "Ahmed, Ren and Wonka, Gaussian Blue Noise, 2022.",
         "For the least power at low frequencies, in 2D and 3D, and for points that follow a density: today's best for "
         "sampling and stippling.",
         "It says nothing about the minimum distance, and in 3D large sets take minutes."},
        {"target-spectrum", "Heck, Schlömer and Deussen, Blue Noise Sampling with Controlled Aliasing, 2013.",
         "For a spectrum that you draw yourself: a step, a peak, or the curve of another method.",
         "Its bytes are the same on processors of one kind only. It is for the plane, and has no minimum distance."},
        {"equal-areas", "De Goes, Breeden, Ostromoukhov and Desbrun, Blue Noise through Optimal Transport, 2012.",
         "For integrals: each point stands for the same area, and power falls with the fourth power of the frequency.",
         "Many moves make it more regular than the published sets: stop at 20 for those."},
    };
}

std::vector<SamplerGuide> guides_to_tiles()
{
    return {
        {"corner-tiles",
         std::string("Lagae and Dutré 2006; ") + dissertation + ", section 4.5. Chains are of this laboratory.",
         "For endless points at the cost of a look-up, with a proven minimum distance: take `border = \"chain\"` and "
         "`ranked = true`.",
         "One finished set of known size is better made by an optimizing method: every tiling shows something of its "
         "lattice."},
        {"edge-tiles", std::string("Lagae and Dutré 2005; ") + dissertation + ", section 4.3.",
         "To compare with corner tiles, or where edges have colours already.",
         "4,096 tiles for two colours. Corner tiles with chains have fewer, and fewer traces of the lattice."},
        {"template-tiles", std::string(dissertation) + ", section 4.4.",
         "For any number of tiles, where only one hash per position is affordable.",
         "All tiles share their border, so the lattice stands out in the spectrum."},
        {"sphere-tiles", std::string(dissertation) + ", section 4.6.",
         "For endless points in space: volumes, asteroids, foam.",
         "Tiles with more than two colours are many (C^8): building them takes long."},
        {"shade-tiles", "Shade, Cohen and Mitchell, Tiling Layered Depth Images, 2000.",
         "For comparison with the earliest tiles.", "Their spectrum shows the tiles plainly. Take corner tiles."},
        {"averaged-tiles", "Hiller, Deussen and Keller 2001; Cohen, Shade, Hiller and Deussen 2003.",
         "To compare: the first tiles that were relaxed over all their surroundings.",
         "Eight tiles repeat soon, and show in the spectrum. Take corner tiles."},
        {"penrose", "Ostromoukhov, Donohue and Jodoin, Fast Hierarchical Importance Sampling, 2004.",
         "For points that follow a density at the cost of a look-up.",
         "For a constant density: its spectrum has peaks of the tiling in it."},
        {"dodecagonal", "Ostromoukhov, SIGGRAPH 2008 class notes, part IV; Gähler 1988 for the tiling.",
         "For extensible sequences of any density, whose first parts keep their points apart.",
         "For integration alone: the discrepancy of Sobol's sequence is lower. The spectrum has the peaks of a "
         "tiling."},
        {"recursive-wang-tiles", "Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang Tiles, 2006.",
         "For zooming without end, into a density that varies.",
         "Its relative radius is near 0.5, more or less by the tile set. Ranked corner tiles keep a proven distance."},
        {"polyominoes", "Ostromoukhov, Sampling with Polyominoes, 2007.",
         "For any number of points at a proven distance, from a small table.",
         "With a density that varies nothing is proven, and the spectrum has the tiling's peaks in it."},
        {"hat-tiles", "Smith, Myers, Kaplan and Goodman-Strauss, An Aperiodic Monotile, 2024, for the tiling.",
         "For points anywhere in an endless plane with a large proven minimum distance.",
         "Sets are windows, not tori, and the spectrum has the peaks of a tiling with long-range order."},
        {"spectre-tiles",
         "Smith, Myers, Kaplan and Goodman-Strauss, A Chiral Aperiodic Monotile, 2024, for the tiling.",
         "For the same purposes as hats, with tiles that are never reflected.",
         "Sets are windows, not tori, and the spectrum has the peaks of a tiling with long-range order."},
        {"isohedral-tiles", "Grünbaum and Shephard, Tilings and Patterns, 1987.",
         "To see what repeating one tile does: a negative example.",
         "For anything else: its spectrum is a lattice of peaks."},
    };
}

const std::vector<SamplerGuide>& all_guides()
{
    static const std::vector<SamplerGuide> all = [] {
        std::vector<SamplerGuide> list;
        for (const auto& some :
             {guides_without_disks(), guides_to_darts(), guides_to_optimized_sets(), guides_to_tiles()})
            list.insert(list.end(), some.begin(), some.end());
        return list;
    }();
    return all;
}

}

const SamplerGuide& sampler_guide(const std::string& sampler)
{
    const auto found = std::ranges::find(all_guides(), sampler, &SamplerGuide::sampler);
    if (found == all_guides().end()) throw std::out_of_range("no guide to the sampler " + sampler);
    return *found;
}

std::string first_sentence(const std::string& text)
{
    const std::size_t end = text.find(". ");
    return end == std::string::npos ? text : text.substr(0, end + 1);
}

}
