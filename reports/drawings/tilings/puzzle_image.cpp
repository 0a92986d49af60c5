#include "reports/drawings/tilings/puzzle_image.hpp"

#include "tiles/packing/puzzle_piece.hpp"

namespace poissonlab {
namespace {

constexpr double sheet_margin = 5;  // around all pieces
constexpr double hairline = 0.1;    // what drivers of laser cutters take for a cut
constexpr double piece_reach = 0.2; // of a knob beyond its tile, and some room

/// Places pieces on the sheet, y downwards.
class PuzzleSheet
{
public:
    PuzzleSheet(const TilePacking& packing, const PuzzleCut& cut)
        : side_(packing.side()), size_(cut.piece),
          pitch_(cut.kerf == 0 ? cut.piece : cut.piece * (1 + 2 * piece_reach) + 2 * cut.kerf)
    {}

    double length() const { return 2 * margin() + pitch_ * (side_ - 1) + size_; }

    /// A point of the piece at a place, in tiles from its lower left corner.
    DrawingPoint at(PackingPlace place, const PiecePoint& point) const
    {
        return {margin() + pitch_ * place.x + size_ * point[0],
                length() - margin() - pitch_ * place.y - size_ * point[1]};
    }

private:
    double margin() const { return sheet_margin + piece_reach * size_; }

    double side_, size_, pitch_;
};

std::vector<DrawingPoint> on_sheet(const PuzzleSheet& sheet, PackingPlace place, const std::vector<PiecePoint>& points)
{
    std::vector<DrawingPoint> drawn;
    for (const PiecePoint& point : points) drawn.push_back(sheet.at(place, point));
    return drawn;
}

/// Each line once: the southern and western sides of every piece, and the far sides of the last ones.
void add_shared_cuts(std::vector<Shape>& shapes, const PuzzleSheet& sheet, const TilePacking& packing,
                     PackingPlace place)
{
    const auto [south, east, north, west] = piece_sides(packing.kind, packing.at(place), packing.colors);
    const auto add = [&](const std::vector<PiecePoint>& side) {
        shapes.push_back({Line{on_sheet(sheet, place, side)}, {}, "#ff0000", hairline});
    };
    add(south);
    add(west);
    if (place.x + 1 == packing.side()) add(east);
    if (place.y + 1 == packing.side()) add(north);
}

}

Drawing draw_puzzle(const TilePacking& packing, const PuzzleCut& cut)
{
    const PuzzleSheet sheet(packing, cut);
    Drawing drawing{sheet.length(), sheet.length(), {}};
    drawing.millimetres_a_unit = 1;
    for (Color y = 0; y < packing.side(); ++y)
        for (Color x = 0; x < packing.side(); ++x) {
            const PackingPlace place{x, y};
            drawing.shapes.push_back(
                {Line{on_sheet(sheet, place, {{0.5, 0.55}, {0.5, 0.75}})}, {}, "#0000ff", hairline});
            if (cut.kerf == 0) {
                add_shared_cuts(drawing.shapes, sheet, packing, place);
                continue;
            }
            const auto outline =
                grown_outline(piece_outline(packing.kind, packing.at(place), packing.colors), cut.kerf / 2 / cut.piece);
            drawing.shapes.push_back({Polygon{on_sheet(sheet, place, outline)}, {}, "#ff0000", hairline});
        }
    return drawing;
}

}
