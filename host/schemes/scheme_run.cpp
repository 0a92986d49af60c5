#include "host/schemes/scheme_run.hpp"

namespace poissonlab {
namespace {

/// Calls the function of a scheme's kind.
struct MakeSchemeKind
{
    std::uint64_t seed;
    DistributionFiles& files;

    DistributionResult operator()(const CornerProblemSettings& settings) const
    {
        return make_corner_problem(settings, seed, files);
    }
    DistributionResult operator()(const ScanlineStepsSettings& settings) const
    {
        return make_scanline_steps(settings, seed, files);
    }
    DistributionResult operator()(const DirectTilingSettings& settings) const
    {
        return make_direct_scheme(settings, files);
    }
    DistributionResult operator()(const NoiseSettings& settings) const { return make_noise(settings, seed, files); }
    DistributionResult operator()(const ConstructionSettings& settings) const
    {
        return make_construction(settings, seed, files);
    }
    DistributionResult operator()(const AperiodicTableSettings& settings) const
    {
        return make_aperiodic_tables(settings, files);
    }
    DistributionResult operator()(const DiffractionSettings& settings) const
    {
        return make_diffraction(settings, files);
    }
    DistributionResult operator()(const IsohedralSettings& settings) const
    {
        return make_isohedral(settings, seed, files);
    }
    DistributionResult operator()(const SurfaceSettings& settings) const { return make_surface(settings, seed, files); }
    DistributionResult operator()(const TilingCostSettings& settings) const
    {
        return make_tiling_costs(settings, seed);
    }
};

}

DistributionResult make_scheme(const SchemeSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    return std::visit(MakeSchemeKind{seed, files}, settings);
}

}
