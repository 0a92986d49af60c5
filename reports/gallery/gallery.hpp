// The gallery of reference curves: radial power, anisotropy and measures of methods, as tables that come with the
// program, to be laid behind the curves of anybody's sets.
//
// docs/gallery/ has the tables, docs/gallery/README.md says how they are made of the program's own results.
#pragma once

#include "reports/plots/curves.hpp"
#include "results/series.hpp"

#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// A method of the gallery, with one choice of its parameters.
struct GalleryMethod
{
    std::string name; ///< in the tables: letters, digits, '.', '_', '-'
    std::string label;
    std::string sampler;
    std::string parameters;                   ///< those that were given, a JSON object
    std::string seed;                         ///< a number; empty for sets that were not made by seed
    std::string program;                      ///< the version that made it
    Curve curve;                              ///< without numbers of samples
    std::map<std::string, Estimate> measures; ///< by their keys in the catalogue
};

/// The texts of the tables.
struct GalleryTables
{
    /// name,dimension,points,realizations,min_distance,sampler,seed,program,parameters,label; the last two in quotes.
    std::string methods;
    /// name,measure,value,standard_error; the error may be empty.
    std::string measures;
    /// name,frequency,power,power_error,anisotropy_db, frequencies in cycles per unit length.
    std::string curves;
};

/// A series that becomes a method of a gallery.
struct GallerySource
{
    const Series* stored = nullptr; ///< with a spectrum
    std::string label;
    const Curve* curve = nullptr;
    std::string seed;
    std::string program; ///< the version that made it
};

/// The name of a series in a gallery: its own one, with "-3d" where its sets have three dimensions.
std::string gallery_name(const GallerySource& source);

/// The tables of series. Numbers are rounded to what their errors leave of them.
GalleryTables gallery_tables(const std::vector<GallerySource>& sources);

/// The methods of tables, in the order of the first one. Throws InputError with table and line.
std::vector<GalleryMethod> read_gallery(const GalleryTables& tables);

/// The gallery that comes with the program.
const std::vector<GalleryMethod>& reference_gallery();

/// The gallery's methods whose sets have that dimension.
std::vector<const GalleryMethod*> reference_gallery(int dimension);

/// The few methods whose curves are laid behind those of sets: all in one plot could not be told apart.
std::vector<const GalleryMethod*> gallery_choice(int dimension);

}
