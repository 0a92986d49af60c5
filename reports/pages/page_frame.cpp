#include "reports/pages/page_frame.hpp"

#include "reports/layout/page_template.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace poissonlab {
namespace {

std::string template_text(const std::string& name)
{
    return std::string(page_template_file("templates/" + name + ".mustache"));
}

void add_partials(PageData& data)
{
    for (const std::string name : {"panel", "overlay", "guide", "provenance", "endless_view", "distribution",
                                   "distribution_group", "at_a_glance"})
        data.set(name, PageData(kainjow::mustache::partial([name] { return template_text(name); })));
}

/// Every field that a template names must be set, to false where a section is left out: else that of a section around
/// it would show.
class StrictContext : public kainjow::mustache::context<std::string>
{
public:
    using context::context;

    const PageData* get(const std::string& name) const override
    {
        if (const PageData* found = context::get(name)) return found;
        throw std::logic_error("a page has no field \"" + name + "\" for its template");
    }
};

PageData navigation(const Site& site, const PageFrame& frame)
{
    PageData list{PageData::type::list};
    for (const auto& page : site.pages) {
        PageData item;
        item.set("text", page.text);
        item.set("link", relative_link(frame.file.parent_path(), site.out / page.file));
        item.set("current", site.out / page.file == frame.file);
        list << item;
    }
    return list;
}

}

std::string render_template(const std::string& name, PageData& data)
{
    add_partials(data);
    kainjow::mustache::mustache text{template_text(name)};
    StrictContext context(&data);
    return text.render(context);
}

std::string render_in_frame(const Site& site, const PageFrame& frame, const std::string& name, PageData& data)
{
    PageData page;
    page.set("title", frame.title);
    page.set("assets", relative_link(frame.file.parent_path(), site.out / asset_folder));
    page.set("pages", navigation(site, frame));
    PageData scripts{PageData::type::list};
    for (const auto& script : frame.scripts) scripts << PageData(script);
    page.set("scripts", scripts);
    page.set("content", render_template(name, data));
    return render_template("frame", page);
}

std::string relative_link(const std::filesystem::path& from_folder, const std::filesystem::path& file)
{
    namespace fs = std::filesystem;
    const auto path = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(from_folder)).generic_string();
    std::string link;
    for (const char c : path) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                           std::string_view("-._~/").find(c) != std::string_view::npos;
        link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<std::uint8_t>(c));
    }
    return link;
}

}
