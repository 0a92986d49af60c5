// Series in memory with known numbers, as the paper's claims ask for them.
#pragma once

#include "reports/layout/report_layout.hpp"

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab::test {

/// A radially averaged power that is `low` up to the principal frequency, where it rises to `peak` within `width` of
/// it, and 1 beyond; with an anisotropy this far above chance, and a ring of `spike` dB.
struct MadeUpCurve
{
    double low = 0.02, peak = 1.5, width = 0.1, beyond = 1;
    double anisotropy = 0;
    double spike = 0; ///< dB above chance of one ring
};

/// Owns what it hands out.
class MadeUpReport
{
public:
    /// A series of K = 10 realizations. `parameters` are as stored.
    ReportSeries& add(const std::string& sampler, const NamedTexts& parameters, std::size_t points = 16384,
                      int dimension = 2);

    static void set_radius(ReportSeries& series, double radius);
    static void set_curve(ReportSeries& series, const MadeUpCurve& curve);
    /// With so many tiles along each axis.
    static void set_peaks(ReportSeries& series, int tiles, double mean_ratio);
    static void set_iterations(ReportSeries& series, std::vector<double> mean_radius);
    /// The root mean square error below and above a quarter of a cycle per pixel.
    static void set_plate_error(ReportSeries& series, double low, double high);

    std::vector<const ReportSeries*> series() const;

private:
    std::deque<Run> runs_;
    std::deque<Series> stored_;
    std::deque<ReportSeries> series_;
};

}
