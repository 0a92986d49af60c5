#include "base/regions/svg/svg_drawing.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/regions/svg/path_lines.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>

namespace poissonlab {
namespace {

constexpr std::string_view svg_space = "http://www.w3.org/2000/svg";

/// Elements that show nothing by themselves, with all that is in them.
constexpr std::array<std::string_view, 16> svg_definitions{
    "defs",   "title",          "desc",           "metadata", "script", "clipPath", "mask",  "symbol",
    "marker", "linearGradient", "radialGradient", "pattern",  "filter", "view",     "style", "cursor"};

/// A style sheet may not set these properties: finding the elements that they hold for takes more than this reader.
constexpr std::array<std::string_view, 6> svg_placing{"display",   "visibility", "fill-rule",
                                                      "transform", "clip-path",  "mask"};

/// Attributes of groups and shapes that would change what is seen, and are not known.
constexpr std::array<std::string_view, 3> svg_refused{"clip-path", "mask", "transform-origin"};

/// A group hands this state on to the elements in it.
struct SvgContext
{
    Geom::Affine to_sheet;
    bool is_even_odd = false;
    bool is_left_out = false; ///< with all that is in it
    bool is_hidden = false;   ///< unless an element in it is visible
};

/// Returns the value of a property in `style`, which goes before the attribute of that name: the last one, unless an
/// earlier one is important.
std::string property_of(const SvgAttributes& attributes, const std::string& name)
{
    const auto style = attributes.find("style");
    std::string_view rest = style == attributes.end() ? std::string_view() : std::string_view(style->second);
    std::string value;
    bool is_kept = false;
    while (!rest.empty()) {
        const std::string_view one = rest.substr(0, rest.find(';'));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos || trimmed(one.substr(0, colon)) != name) continue;
        const std::string_view said = one.substr(colon + 1);
        const bool is_important = said.find('!') != std::string_view::npos; // "none !important"
        if (is_kept && !is_important) continue;
        is_kept = is_important;
        value = trimmed(said.substr(0, said.find('!')));
    }
    if (!value.empty()) return value;
    const auto attribute = attributes.find(name);
    return attribute == attributes.end() ? "" : std::string(trimmed(attribute->second));
}

/// True for a value of `clip-path`, `mask`, `transform-origin` or `transform` by which an element is as without it.
bool is_without(std::string_view value)
{
    static constexpr std::array<std::string_view, 6> words{"", "none", "initial", "unset", "revert", "revert-layer"};
    return std::ranges::find(words, value) != words.end();
}

class SvgReader
{
public:
    explicit SvgReader(const std::string& name) : name_(name), parser_(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree)
    {
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), begin_element, end_element);
        XML_SetCharacterDataHandler(parser_.get(), take_text);
    }

    std::vector<SvgShape> read(const std::string& content)
    {
        const auto size = static_cast<int>(content.size());
        const bool is_read = XML_Parse(parser_.get(), content.data(), size, 1) == XML_STATUS_OK;
        if (error_) std::rethrow_exception(error_);
        if (!is_read) throw problem(fmt::format("is not XML: {}", XML_ErrorString(XML_GetErrorCode(parser_.get()))));
        return std::move(shapes_);
    }

private:
    static void begin_element(void* reader, const XML_Char* name, const XML_Char** attributes)
    {
        auto& self = *static_cast<SvgReader*>(reader);
        self.guarded([&] { self.begin(name, attributes); });
    }
    static void end_element(void* reader, const XML_Char* /*name*/)
    {
        auto& self = *static_cast<SvgReader*>(reader);
        self.guarded([&] { self.end(); });
    }
    static void take_text(void* reader, const XML_Char* text, int size)
    {
        auto& self = *static_cast<SvgReader*>(reader);
        if (self.is_sheet_) self.sheet_.append(text, static_cast<std::size_t>(size));
    }

    /// No exception may pass through the library.
    template <class Work>
    void guarded(const Work& work)
    {
        if (error_) return;
        try {
            work();
        } catch (...) {
            error_ = std::current_exception();
            XML_StopParser(parser_.get(), XML_FALSE);
        }
    }

    std::string place() const { return fmt::format("{}:{}", name_, XML_GetCurrentLineNumber(parser_.get())); }

    InputError problem(const std::string& what) const { return InputError(fmt::format("{}: {}", place(), what)); }

    void begin(std::string_view name, const XML_Char** list)
    {
        const std::size_t blank = name.find(' ');
        const bool is_foreign = blank != std::string_view::npos && name.substr(0, blank) != svg_space;
        const std::string element(blank == std::string_view::npos ? name : name.substr(blank + 1));
        SvgAttributes attributes;
        for (; *list != nullptr; list += 2) attributes[list[0]] = list[1];
        if (contexts_.empty()) {
            if (is_foreign || element != "svg")
                throw problem(fmt::format("is no drawing of SVG: begins with <{}>", printable(element)));
            contexts_.push_back({sheet_of(attributes)});
            enter(contexts_.back(), element, attributes);
            return;
        }
        SvgContext context = contexts_.back();
        is_sheet_ = element == "style" && !is_foreign;
        context.is_left_out =
            context.is_left_out || is_foreign || std::ranges::find(svg_definitions, element) != svg_definitions.end();
        if (!context.is_left_out) enter(context, element, attributes);
        if (!context.is_left_out) add(context, element, attributes);
        contexts_.push_back(context);
    }

    void end()
    {
        contexts_.pop_back();
        if (!std::exchange(is_sheet_, false)) return;
        for (const std::string_view word : svg_placing)
            if (sheet_.find(word) != std::string::npos)
                throw problem(fmt::format("<style>: says {}, which counts in attributes alone here", word));
        sheet_.clear();
    }

    /// From user units to those of the sheet's lower left corner, upwards.
    Geom::Affine sheet_of(const SvgAttributes& attributes) const
    {
        const auto box = attributes.find("viewBox");
        if (box != attributes.end()) {
            const auto numbers = svg_numbers(box->second);
            if (!numbers || numbers->size() != 4)
                throw problem(fmt::format("viewBox \"{}\": must be four numbers", shortened(printable(box->second))));
            return {1, 0, 0, -1, -(*numbers)[0], (*numbers)[1] + (*numbers)[3]};
        }
        const auto height = attributes.find("height");
        return {1, 0, 0, -1, 0, height == attributes.end() ? 0 : svg_length(height->second).value_or(0)};
    }

    /// Takes over what attributes of a group or of a shape say.
    void enter(SvgContext& context, const std::string& element, const SvgAttributes& attributes)
    {
        context.is_left_out = context.is_left_out || property_of(attributes, "display") == "none";
        if (context.is_left_out) return;
        for (const std::string_view refused : svg_refused) {
            const std::string value = property_of(attributes, std::string(refused));
            if (!is_without(value) && value != "inherit") // a group that has one is refused
                throw problem(fmt::format("<{}>: {} is not known here", printable(element), refused));
        }
        const std::string rule = property_of(attributes, "fill-rule"), seen = property_of(attributes, "visibility");
        // Other words, such as inherit and unset, leave both as the group has them.
        if (rule == "evenodd" || rule == "nonzero" || rule == "initial") context.is_even_odd = rule == "evenodd";
        if (seen == "visible" || seen == "initial") context.is_hidden = false;
        if (seen == "hidden" || seen == "collapse") context.is_hidden = true;
        const std::string transform = property_of(attributes, "transform");
        if (is_without(transform)) return;
        const auto step = svg_transform(transform);
        if (!step || !(std::abs(step->det()) > 0) || !std::isfinite(step->det()))
            throw problem(fmt::format("<{}>: transform \"{}\": must be made of matrix, translate, scale, rotate, skewX "
                                      "and skewY, and leave an area",
                                      printable(element), shortened(printable(transform))));
        context.to_sheet = *step * context.to_sheet;
    }

    void add(const SvgContext& context, const std::string& element, const SvgAttributes& attributes)
    {
        if (element == "g" || element == "a") return;
        const std::string shape = fmt::format("{}: <{}>", place(), printable(element));
        std::optional<Geom::PathVector> outline;
        try {
            outline = svg_outline(element, attributes);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", shape, error.what()));
        }
        if (!outline)
            throw InputError(fmt::format("{}: is not known here: regions are made of path, polygon, polyline, line, "
                                         "rect, circle and ellipse, in groups (g)",
                                         shape));
        if (context.is_hidden) return;
        PathLines lines;
        lines.feed(*outline * context.to_sheet);
        shapes_.push_back(shape_of(std::move(lines), shape, context.is_even_odd));
    }

    const std::string& name_;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
    std::vector<SvgContext> contexts_;
    std::vector<SvgShape> shapes_;
    std::string sheet_; ///< the text of a style sheet
    bool is_sheet_ = false;
    std::exception_ptr error_;
};

}

std::vector<SvgShape> read_svg_drawing(const std::string& content, const std::string& name)
{
    return SvgReader(name).read(content);
}

}
