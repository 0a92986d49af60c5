// The plots of integration errors over the number of points, with what each function is.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"

#include <fmt/format.h>

#include <map>

namespace poissonlab {

namespace {

std::string meaning_of(const std::string& integrand)
{
    static const std::map<std::string, std::string> meanings = {
        {"disk", "1 in a disk of radius 0.3, else 0"},
        {"ball", "1 in a ball of radius 0.3, else 0"},
        {"step", "1 on one side of a slanted line (3D: plane), else 0"},
        {"gaussian", "a bump of standard deviation 0.2 around the centre"},
        {"cosine", "product of 1 + cos 2πx, smooth across the borders as well"},
        {"bilinear", "x y, with a jump at the borders"},
        {"trilinear", "x y z, with a jump at the borders"},
    };
    const auto found = meanings.find(integrand);
    return found == meanings.end() ? "a function of the position" : found->second;
}

}

PageData integration_panels(const std::vector<ReportSeries>& series, const OverlayPlace& place)
{
    PageData list{PageData::type::list};
    const auto curves = integration_curves(series);
    for (const auto& integrand : integrands_of(curves)) {
        auto alt = fmt::format("Error of the integral of {} over the number of points: ", integrand);
        for (const auto& curve : curves)
            if (curve.integrand == integrand) alt += curve.label + "; ";
        const auto stem = integration_prefix + integrand;
        PageData data;
        data.set("title", integrand);
        data.set("meaning", meaning_of(integrand));
        data.set("alt", alt);
        data.set("source", relative_link(place.page_folder, place.plots / (stem + ".svg")));
        data.set("svg", relative_link(place.page_folder, place.plots / (stem + ".svg")));
        data.set("png", relative_link(place.page_folder, place.plots / (stem + ".png")));
        list << data;
    }
    return list;
}

}
