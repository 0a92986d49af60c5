#include "reports/layout/panel.hpp"

namespace poissonlab {

namespace {

bool is_vector_graphics(const Panel& panel)
{
    return panel.plot() || std::holds_alternative<PointsView>(panel.picture) ||
           std::holds_alternative<CellsView>(panel.picture) || std::holds_alternative<MarkPanel>(panel.picture);
}

}

std::string shown_file(const Panel& panel)
{
    if (is_vector_graphics(panel)) return panel.stem + ".svg";
    const auto* spectrum = std::get_if<SpectrumPicture>(&panel.picture);
    return panel.stem + (spectrum && spectrum->part == SpectrumPicture::Part::whole ? "-small.png" : ".png");
}

std::string full_size_file(const Panel& panel) { return panel.plot() ? panel.stem + ".svg" : print_file(panel); }

std::string thumbnail_file(const Panel& panel)
{
    return panel.stem + (panel.plot() ? "-thumbnail.svg" : "-thumbnail.png");
}

std::string print_file(const Panel& panel) { return panel.stem + ".png"; }

}
