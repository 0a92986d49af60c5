// Claims of chapter 5 about texture tiles.
#include "tests/reports/support/claim_cases.hpp"

namespace poissonlab::test {
namespace {

using Kind = ClaimCase::Kind;
using Numbers = std::map<std::string, double>;

/// Textures of one exemplar, whose numbers have an error of a hundredth of 1 where there are several sets.
DistributionResult& texture(MadeUpReport& report, const char* kind, const char* stages, const Numbers& numbers,
                            const char* tiles = "complete", const char* colors = "2", bool several = true)
{
    Numbers all = numbers;
    all.try_emplace("tiles", 16);
    DistributionResult& result = report.add_scheme("texture", all, several ? std::optional(0.01) : std::nullopt);
    result.parameters = {{"exemplar", "brick"}, {"kind", kind},   {"colors", colors}, {"size", "64"},
                         {"smooth", "false"},   {"tiles", tiles}, {"stages", stages}};
    return result;
}

/// One placement against another by a measure; `first` is the kind that the claim is about.
ClaimCase compared(const char* id, const char* first, const char* second, const char* measure, double better,
                   double worse)
{
    return {id, [=](MadeUpReport& r, Told what) {
                const std::string other = second;
                texture(r, first, "1", {{measure, told(what, better, worse, better)}}, "complete", "4",
                        what != Told::nothing);
                texture(r, second, other == "wang" ? "3" : "0", {{measure, 1}});
            }};
}

}

std::vector<ClaimCase> cases_of_textures()
{
    return {
        {"cohen-2003-fit",
         [](MadeUpReport& r, Told what) {
             texture(r, "wang", "3",
                     what == Told::nothing ? Numbers{} : Numbers{{"border_exceptions", told(what, 0.0, 0.9, 0.0)}});
         },
         Kind::exact},
        {"5.3-corners",
         [](MadeUpReport& r, Told what) {
             texture(r, "corner", "3",
                     what == Told::nothing ? Numbers{} : Numbers{{"border_exceptions", told(what, 0.0, 0.9, 0.0)}});
         },
         Kind::exact},
        {"cohen-2003-marked",
         [](MadeUpReport& r, Told what) {
             DistributionResult& marked =
                 texture(r, "wang", "3", {{"tiles", told(what, 128.0, 100.0, 128.0)}}, "compact");
             if (what != Told::nothing) marked.parameters.push_back({"marked_exemplar", "snow"});
         },
         Kind::exact},
        {"cohen-2003-more-tiles",
         [](MadeUpReport& r, Told what) {
             texture(r, "wang", "3", {{"lattice_power", 0.2}}, "compact", "2");
             texture(r, "wang", "3", {{"lattice_power", told(what, 0.1, 0.3, 0.19)}}, "compact", "3");
         }},
        compared("5.3-new-patch", "corner", "corner", "coverage", 2, 0.5),
        compared("5.3-similar", "corner", "wang", "color_distance", 0.5, 2),
        compared("ng-2005-large", "omega", "wang", "double_lattice_power", 0.5, 2),
        compared("ng-2005-junctions", "omega", "wang", "conspicuous_seams", 0.5, 2),
        compared("ng-2005-straight", "omega", "wang", "seam_mismatch", 2, 0.5),
        {"5.4-frames",
         [](MadeUpReport& r, Told what) {
             texture(r, "corner", "3", {{"frames", told(what, 310.0, 25.0, 200.0)}});
         },
         Kind::shown},
    };
}

}
