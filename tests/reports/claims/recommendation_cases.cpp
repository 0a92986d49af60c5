// The recommendations of 6.16.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;

/// A method beside others: more anisotropic than they are, less, or about as much. The best series of the others is no
/// better than the method.
void among_others(MadeUpReport& report, const std::string& sampler, Told what)
{
    for (const char* other : {"lloyd", "dart-throwing", "sector-darts"})
        MadeUpReport::set_curve(report.add(other, {}), {.anisotropy = 1, .scatter = 1});
    MadeUpReport::set_curve(report.add(sampler, {{"drawing", "once"}}),
                            {.anisotropy = told(what, 5.0, 0.2, 1.0), .scatter = 1});
}

/// Tiles of two kinds whose mean anisotropy above chance is given.
void two_kinds(MadeUpReport& r, const char* kind, int set, double of_corners, double of_others, bool one_set)
{
    for (const auto& [name, count, anisotropy] : {std::tuple("corner", 3, of_corners), {kind, set, of_others}}) {
        ReportSeries& series = tiles(r, name, count, 64, 2);
        series.curve.bins.clear();
        MadeUpReport::set_curve(series, {.anisotropy = anisotropy, .scatter = 0.1});
        if (one_set) have_one_set(series);
    }
}

void averaged_and_edges(MadeUpReport& r, Told what)
{
    const char* sets = told(what, "3", "3", "1");
    for (const double radius : {0.70, 0.75}) {
        auto& edges = r.add("edge-tiles", {{"sets", sets}});
        MadeUpReport::set_radius(edges, radius);
        MadeUpReport::set_curve(edges, {.anisotropy = 1, .scatter = 0.1});
    }
    // One series that is good does not refute it, and one that is bad does not show it.
    auto& averaged = r.add("averaged-tiles", {{"sets", sets}});
    MadeUpReport::set_radius(averaged, told(what, 0.6, 0.8, 0.6));
    MadeUpReport::set_curve(averaged, {.anisotropy = told(what, 3.0, 0.1, 3.0), .scatter = 0.1});
}

std::vector<ClaimCase> shown_recommendations()
{
    const auto timed = [](const char* id, const char* sampler) -> ClaimCase {
        return {id,
                [sampler](MadeUpReport& r, Told what) { set_seconds(r.add(sampler, {}), told(what, 1e-4, 10.0, 0.1)); },
                Kind::shown};
    };
    return {timed("6.16-not-interactive", "dart-throwing"),
            timed("6.16-interactive", "sector-darts"),
            timed("6.16-real-time", "corner-tiles"),
            timed("6.16-only-option", "lloyd"),
            {"6.16-shade",
             [](MadeUpReport& r, Told what) {
                 ReportSeries& series = r.add("shade-tiles", {});
                 MadeUpReport::set_radius(series, 0.7);
                 set_number(series, "border_density", told(what, 0.5, 1.5, 1.0));
             },
             Kind::shown}};
}

}

std::vector<ClaimCase> cases_of_recommendations()
{
    std::vector<ClaimCase> cases{
        {"6.16-averaged", averaged_and_edges},
        {"6.16-template",
         [](MadeUpReport& r, Told what) {
             two_kinds(r, "template", 128, 1, told(what, 3.0, 0.1, 3.0), what == Told::nothing);
         }},
        {"6.16-corner",
         [](MadeUpReport& r, Told what) {
             two_kinds(r, "edge", 2, told(what, 1.0, 3.0, 1.0), 2, what == Told::nothing);
         }},
        {"6.16-penrose", [](MadeUpReport& r, Told what) { among_others(r, "penrose", what); }},
        {"6.16-recursive", [](MadeUpReport& r, Told what) { among_others(r, "recursive-wang-tiles", what); }},
        {"6.16-recursive-radius",
         [](MadeUpReport& r, Told what) {
             ReportSeries& series = r.add("recursive-wang-tiles", {{"drawing", "once"}});
             MadeUpReport::set_radius(series, told(what, 0.3, 0.6, 0.6));
             if (what == Told::nothing) stored_of(series).realizations = 1;
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {{"drawing", "twice"}}), 0.0);
         }},
    };
    const auto more = shown_recommendations();
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}
