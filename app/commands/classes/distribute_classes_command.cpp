// poissonlab distribute classes: points of several classes on the unit torus.
#include "app/commands/kind_options.hpp"
#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_source.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/kinds/kinds.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_classes_notes =
    R"help(Each class and all together are even (Wei 2010): points of the same class keep its distance, points of two classes the
distance of the density that both, and all classes of larger distances, have together. Each point is of the class that is
least filled: darts of it are thrown until one fits. --points ends there; else the set ends when no further point of any
class fits, which is proven. Distances are those of --distances, in sides of the torus, or of --relative-radius for so
many points, or of all pairs: --matrix, row after row. With --factor all distances are multiplied by it wherever a class
has no room for its next point, until there is room for --points. With --tiles the points are those of a torus of
tiles whose points have classes (tiles build --class-points), and each pair of classes keeps what is proven of the set.
With --region points lie in polygons with holes, from GeoJSON, WKT, drawings, pictures or formulas, as with distribute darts.
Distances are in the region's units, or in metres if it is in longitude and latitude; files have the region's coordinates.
With --along they lie on its lines and outlines, --per-length of each class on a unit of length.
Points keep --obstacle-distance from --obstacles. With --densities, once for each class, points of classes follow pictures or
formulas in the region. With --feature-points or --feature-densities properties of the features of a GeoJSON file say how many
points of each class lie in them; .geojson has the properties of each point's feature.
Classes are counted from 0, in the order in which they are given. --out, as often as you like: .csv (columns x, y, class),
.ply (vertices with a class), .npy (records x, y, class), .geojson (features with the property class), .svg and .png (disks in
colours). --spectra FILE.csv has the radially averaged power of each class and of all, and cross power of pairs: with --sets
means over so many sets, and errors.
  poissonlab distribute classes --points 100 400 1600 --out forest.csv --out forest.png
  poissonlab distribute classes --distances 0.1 0.05 0.02 --out full.ply
  poissonlab distribute classes --tiles forest.ptiles --torus 12 --out forest.png --spectra forest.csv
  poissonlab distribute classes --region park.geojson --distances 12 5 2 --out plants.geojson --out plants.png
  poissonlab distribute classes --region park.geojson --points 40 300 --densities trees.png --densities "exp(-x/50)" --out park.csv
  poissonlab distribute classes --region beds.geojson --feature-points trees shrubs --distances 6 2 --out plants.geojson
  poissonlab distribute classes --region paths.geojson --along --per-length 0.02 0.05 --distances 15 6 --out lamps.geojson
  poissonlab distribute classes --matrix 0.05 0.02 0.02 0.05 --sets 10 --out two.npy --spectra two.csv)help";

struct ClassOptions : KindOptions
{
    using KindOptions::KindOptions;
    OutputFiles outs{{{".csv", ".ply", ".npy", ".geojson", ".svg", ".png"}}};
    std::string spectra;
};

void write_class_output(const std::filesystem::path& file, const ClassSet& set, const std::string& comment)
{
    if (std::ranges::find(class_file_ends(), file.extension().string()) != class_file_ends().end())
        return write_class_file(file, set.as_in_files(), comment, set.region(), set.features());
    write_picture_file(file, draw_marks(class_picture(set), {}));
}

void throw_class_points(const ClassOptions& o)
{
    const KindSettings read = o.settings();
    const auto& settings = read.as<ClassSettings>();
    o.outs.check(o.command());
    if (o.spectra.empty() && settings.sets > 1)
        throw InputError(fmt::format("--sets {}: needs --spectra", settings.sets));
    std::filesystem::path spectra;
    if (!o.spectra.empty()) {
        if (settings.dimension != 2) throw InputError("--spectra: is for points of the plane, --dimension 2");
        if (settings.has_region()) throw InputError("--spectra: is for the torus, and --region is given");
        spectra = checked_output(o.command(), "--spectra", o.spectra, {{".csv"}});
    }
    const ClassSet set = throw_classes(settings, o.seed(), o.place());
    const std::string what =
        fmt::format("{} {} of {} {}: {}", set.points.points.size(), noun(set.points.points.size(), "point"),
                    set.points.is_full.size(), noun(set.points.is_full.size(), "class", "classes"),
                    fmt::join(set.points.counts(), ", "));
    o.say_note(!settings.has_numbers() && settings.tiles.empty() ? what + "; no further one fits" : what);
    if (set.region())
        for (const std::string& note : notes_of(*set.region())) o.say_note(note);
    for (const std::string& note : density_notes(set)) o.say_note(note);
    const std::string comment = o.command_comment(what);
    for (const std::filesystem::path& out : o.outs.files()) write_class_output(out, set, comment);
    if (!spectra.empty()) write_whole_file(spectra, spectra_csv(averaged_spectra(settings, o.seed(), o.place(), set)));
    if (o.prints_json()) print_numbers(class_numbers(set));
}

}

Command distribute_classes_command()
{
    const auto o = std::make_shared<ClassOptions>(*find_kind("distribution", "classes"));
    return kind_command(
        o, {o->outs.option(), {"--spectra", &o->spectra, "Write radial spectra to this .csv file", "FILE"}},
        distribute_classes_notes, throw_class_points);
}

}
