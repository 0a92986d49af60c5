// WKT: OGC 06-103r4, section 7; SRID before it as PostGIS writes it.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/regions/formats/region_shapes.hpp"
#include "base/regions/region_words.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

namespace poissonlab {
namespace {

/// Collections may be nested so deep.
constexpr int deepest_collection = 32;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

class WktReader
{
public:
    WktReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    RegionShapes read()
    {
        do { // files may have several, one a line
            read_srid();
            read_geometry(0);
            skip_blanks();
            if (rest_.starts_with(';')) rest_.remove_prefix(1);
            skip_blanks();
        } while (is_wkt_text(rest_));
        if (!rest_.empty()) throw problem("goes on after its end: " + shown_rest());
        return std::move(found_);
    }

private:
    InputError problem(const std::string& what) const { return InputError(name_ + ": is not WKT: " + what); }

    std::string shown_rest() const { return shortened(printable(rest_), 40); }

    void skip_blanks()
    {
        while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    }

    /// SRID=4326; and SRID=0; for a system that is not known.
    void read_srid()
    {
        if (rest_.size() < 5 || word_ahead() != "SRID") return;
        const std::size_t end = rest_.find(';');
        if (end == std::string_view::npos) throw problem("no ; after SRID=");
        const std::string number(rest_.substr(5, end - 5));
        if (rest_[4] != '=' || number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
            throw problem(shortened(printable(rest_.substr(0, end))) + ": must be SRID= and a number");
        if (number.find_first_not_of('0') != std::string::npos) {
            const std::string before = std::exchange(found_.system, "EPSG:" + number);
            if (!before.empty() && before != found_.system)
                throw problem(fmt::format("has several systems of coordinates, {} and {}", before, found_.system));
        }
        rest_.remove_prefix(end + 1);
    }

    /// The next word in capitals, which stays where it is.
    std::string word_ahead()
    {
        skip_blanks();
        std::string word;
        for (const char c : rest_) {
            if (!is_letter(c)) break;
            word.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
        }
        return word;
    }

    bool takes_word(const std::string& word)
    {
        if (word_ahead() != word) return false;
        rest_.remove_prefix(word.size());
        return true;
    }

    bool takes(char mark)
    {
        skip_blanks();
        if (!rest_.starts_with(mark)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void need(char mark)
    {
        if (!takes(mark))
            throw problem(rest_.empty() ? fmt::format("it ends where {} should follow", mark)
                                        : fmt::format("{}: {} should stand before it", shown_rest(), mark));
    }

    /// The word of a geometry, without the Z, M or ZM that may stand right behind it.
    std::string read_type()
    {
        std::string type = word_ahead();
        const std::string typed = type;
        rest_.remove_prefix(type.size());
        for (const char* dimensions : {"ZM", "Z", "M"}) takes_word(dimensions);
        for (const char* known :
             {"POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"})
            for (const char* dimensions : {"", "Z", "M", "ZM"})
                if (type == std::string(known) + dimensions) return known;
        throw problem(fmt::format("{}: must be POINT, LINESTRING, POLYGON, MULTI... of these, or GEOMETRYCOLLECTION",
                                  typed.empty() ? shown_rest() : shortened(typed)));
    }

    void read_geometry(int depth)
    {
        const std::string type = read_type();
        if (type == "GEOMETRYCOLLECTION") {
            if (depth == deepest_collection) throw problem("collections are nested too deep");
            return each_member([&] { read_geometry(depth + 1); });
        }
        if (type == "POINT") return read_point();
        if (type == "LINESTRING") return read_line();
        if (type == "POLYGON") return read_polygon();
        each_member([&] {
            if (type == "MULTIPOINT") return read_point_of_several();
            type == "MULTILINESTRING" ? read_line() : read_polygon();
        });
    }

    /// Members in brackets with commas between them, or EMPTY.
    template <class Read>
    void each_member(const Read& read)
    {
        if (takes_word("EMPTY")) return;
        need('(');
        do read();
        while (takes(','));
        need(')');
    }

    double read_number()
    {
        skip_blanks();
        const std::string_view word = rest_.substr(0, rest_.find_first_of("(), \t\r\n"));
        double number = 0;
        if (!parse_number(word, number)) throw problem(shortened(printable(word)) + ": must be a number");
        rest_.remove_prefix(word.size());
        return number;
    }

    /// Two numbers, and up to two more, which are left out.
    std::array<double, 2> read_position()
    {
        skip_blanks();
        const std::string_view words = rest_.substr(0, rest_.find_first_of("(),"));
        std::array<double, 4> numbers{};
        std::size_t count = 0;
        for (skip_blanks(); !rest_.empty() && std::string_view("(),").find(rest_.front()) == std::string_view::npos;
             skip_blanks()) {
            if (count == numbers.size()) break;
            numbers[count++] = read_number();
        }
        const bool is_over = !rest_.empty() && std::string_view("(),").find(rest_.front()) == std::string_view::npos;
        if (count < 2 || is_over) {
            std::string_view shown = words;
            while (!shown.empty() && is_blank(shown.back())) shown.remove_suffix(1);
            throw problem(shortened(printable(shown)) +
                          ": must be two numbers, or as many as four with a height and a measure");
        }
        found_.has_further_numbers |= count > 2;
        return {numbers[0], numbers[1]};
    }

    RegionRing read_positions()
    {
        RegionRing positions;
        each_member([&] { positions.push_back(read_position()); });
        return positions;
    }

    void read_point()
    {
        if (takes_word("EMPTY")) return;
        need('(');
        found_.shapes.points.push_back(read_position());
        need(')');
    }

    /// Points of several stand in brackets of their own, or in none.
    void read_point_of_several()
    {
        skip_blanks();
        if (rest_.starts_with('(') || word_ahead() == "EMPTY") return read_point();
        found_.shapes.points.push_back(read_position());
    }

    void read_line()
    {
        RegionRing line = read_positions();
        if (line.empty()) return;
        if (line.size() < 2) throw InputError(name_ + ": a line must have two positions or more");
        found_.shapes.lines.push_back(std::move(line));
    }

    void read_polygon()
    {
        std::vector<RegionRing> rings;
        each_member([&] {
            RegionRing ring = read_positions();
            if (ring.size() < 4 || ring.front() != ring.back())
                throw InputError(name_ +
                                 ": a ring is not closed: its last position must be its first, of four or more");
            ring.pop_back();
            rings.push_back(std::move(ring));
        });
        if (rings.empty()) return;
        RegionPolygon& polygon = found_.shapes.polygons.emplace_back();
        polygon.outline = std::move(rings.front());
        polygon.holes.assign(std::make_move_iterator(rings.begin() + 1), std::make_move_iterator(rings.end()));
    }

    std::string_view rest_;
    const std::string& name_;
    RegionShapes found_;
};

}

RegionShapes shapes_of_wkt(std::string_view text, const std::string& name) { return WktReader(text, name).read(); }

}
