#include "tiles/prototiles/ring_expression.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <string>

namespace poissonlab {
namespace {

constexpr int largest_integer = 1'000'000;                  // so that products of a few fit
constexpr std::int64_t largest_product = 1'000'000'000'000; // so that sums fit
constexpr int most_parentheses = 50;

/// Reads sums of products of factors, from left to right.
class RingExpressionReader
{
public:
    RingExpressionReader(const RootRing& ring, std::string_view text, bool allows_shifts)
        : ring_(ring), text_(text), allows_shifts_(allows_shifts)
    {}

    ShiftedPlace read()
    {
        const ShiftedPlace sum = read_sum();
        if (!at_end()) throw wrong(fmt::format("\"{}\" is not expected", text_[place_]));
        return sum;
    }

private:
    bool at_end()
    {
        while (place_ < text_.size() && text_[place_] == ' ') ++place_;
        return place_ == text_.size();
    }

    char next() { return at_end() ? '\0' : text_[place_]; }

    bool takes(char sign)
    {
        if (next() != sign) return false;
        ++place_;
        return true;
    }

    static InputError wrong(const std::string& what) { return InputError(what); }

    ShiftedPlace read_sum()
    {
        ShiftedPlace sum = takes('-') ? product(read_product(), {{{-1, 0, 0, 0}}}) : (takes('+'), read_product());
        for (;;) {
            const bool adds = takes('+');
            if (!adds && !takes('-')) return sum;
            const ShiftedPlace next = product(read_product(), {{{adds ? 1 : -1, 0, 0, 0}}});
            sum.place = sum.place + next.place;
            for (std::size_t i = 0; i < 2; ++i) sum.shifts[i] = sum.shifts[i] + next.shifts[i];
        }
    }

    ShiftedPlace read_product()
    {
        ShiftedPlace all = read_factor();
        while (takes('*') || (next() != '\0' && next() != '+' && next() != '-' && next() != ')'))
            all = product(all, read_factor());
        return all;
    }

    static bool has_shifts(const ShiftedPlace& a) { return a.shifts != std::array<RingPlace, 2>{}; }

    ShiftedPlace product(const ShiftedPlace& a, const ShiftedPlace& b) const
    {
        if (has_shifts(a) && has_shifts(b)) throw wrong("has a product of p and q");
        ShiftedPlace result{ring_.times(a.place, b.place)};
        for (std::size_t i = 0; i < 2; ++i)
            result.shifts[i] = ring_.times(a.shifts[i], b.place) + ring_.times(a.place, b.shifts[i]);
        for (const RingPlace* part : {&result.place, &result.shifts[0], &result.shifts[1]})
            for (const std::int64_t c : part->c)
                if (c > largest_product || c < -largest_product) throw wrong("is too large");
        return result;
    }

    ShiftedPlace read_factor()
    {
        if (takes('(')) {
            if (++depth_ > most_parentheses) throw wrong("has too many parentheses");
            const ShiftedPlace sum = read_sum();
            if (!takes(')')) throw wrong("lacks a )");
            --depth_;
            return sum;
        }
        if (takes('@')) return {read_direction()};
        if (std::isdigit(static_cast<unsigned char>(next())) != 0) return {{{read_integer(), 0, 0, 0}}};
        return read_word();
    }

    RingPlace read_direction()
    {
        const int sign = takes('-') ? -1 : 1, degrees = read_integer();
        const int step = 360 / ring_.order();
        if (degrees % step != 0)
            throw wrong(fmt::format("@{}: degrees must be multiples of {} here", sign * degrees, step));
        return ring_.unit(sign * (degrees / step % ring_.order()));
    }

    int read_integer()
    {
        at_end();
        int value = 0;
        const char* const first = text_.data() + place_;
        const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
        if (error != std::errc() || value > largest_integer)
            throw wrong(
                fmt::format("must have an integer from 0 to {} at \"{}\"", largest_integer, text_.substr(place_, 12)));
        place_ += static_cast<std::size_t>(end - first);
        return value;
    }

    ShiftedPlace read_word()
    {
        std::string word;
        while (!at_end() && std::isalnum(static_cast<unsigned char>(text_[place_])) != 0) {
            word += text_[place_++];
            if (place_ < text_.size() && text_[place_] == ' ') break;
        }
        const RingPlace twice_cosine = ring_.unit(1) + ring_.unit(-1); // of the ring's smallest angle
        if (word == "i" && ring_.order() % 4 == 0) return {ring_.unit(ring_.order() / 4)};
        if (word == "phi" && ring_.order() == 10) return {twice_cosine};
        if (word == "sqrt2" && ring_.order() == 8) return {twice_cosine};
        if (word == "sqrt3" && ring_.order() == 12) return {twice_cosine};
        if (allows_shifts_ && (word == "p" || word == "q")) {
            ShiftedPlace shift;
            shift.shifts[word == "p" ? 0 : 1] = ring_.unit(0);
            return shift;
        }
        if (word.empty()) throw wrong(at_end() ? "ends too early" : fmt::format("has a \"{}\"", text_[place_]));
        throw wrong(fmt::format("\"{}\" is not a number of {} directions; known: {}", word, ring_.order(),
                                ring_.order() == 8    ? "i, sqrt2, @45"
                                : ring_.order() == 10 ? "phi, @36"
                                                      : "i, sqrt3, @30"));
    }

    const RootRing& ring_;
    std::string_view text_;
    bool allows_shifts_;
    std::size_t place_ = 0;
    int depth_ = 0;
};

}

RingPlace ring_expression(const RootRing& ring, std::string_view text)
{
    return RingExpressionReader(ring, text, false).read().place;
}

ShiftedPlace shifted_expression(const RootRing& ring, std::string_view text)
{
    return RingExpressionReader(ring, text, true).read();
}

}
