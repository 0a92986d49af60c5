#include "tests/support/browser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace poissonlab::test {

namespace {

using Json = nlohmann::json;

/// Without a graphics card Chromium warns of its own way to bring WebGL to the screen.
bool is_of_software_graphics(const std::string& text)
{
    return text.find("GPU stall due to ReadPixels") != std::string::npos;
}

std::string file_url(const std::filesystem::path& path)
{
    constexpr auto digits = "0123456789ABCDEF";
    std::string url = "file://";
    for (const char c : std::filesystem::absolute(path).string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = std::isalnum(byte) || std::string_view("/-._~").find(c) != std::string_view::npos;
        if (plain)
            url += c;
        else
            url.append({'%', digits[byte >> 4], digits[byte & 15]});
    }
    return url;
}

bool is_local(const std::string& url)
{
    return std::ranges::any_of(std::array{"file:", "data:", "blob:", "about:"},
                               [&](const char* scheme) { return url.starts_with(scheme); });
}

struct Key
{
    std::string name; ///< KeyboardEvent.key
    std::string code;
    int number = 0; ///< Windows' virtual key code, which Chromium acts on
    std::string text;
};

Key key_of(const std::string& key)
{
    static const std::map<std::string, Key> named = {
        {"Tab", {"Tab", "Tab", 9, ""}},
        {"Enter", {"Enter", "Enter", 13, "\r"}},
        {"Escape", {"Escape", "Escape", 27, ""}},
        {"Space", {" ", "Space", 32, " "}},
        {"End", {"End", "End", 35, ""}},
        {"Home", {"Home", "Home", 36, ""}},
        {"ArrowLeft", {"ArrowLeft", "ArrowLeft", 37, ""}},
        {"ArrowUp", {"ArrowUp", "ArrowUp", 38, ""}},
        {"ArrowRight", {"ArrowRight", "ArrowRight", 39, ""}},
        {"ArrowDown", {"ArrowDown", "ArrowDown", 40, ""}},
    };
    if (const auto found = named.find(key); found != named.end()) return found->second;
    if (key.size() != 1) throw BrowserError("press: unknown key \"" + key + "\"");
    return {key, "", std::toupper(static_cast<unsigned char>(key[0])), key};
}

/// The rectangle of an element, as JavaScript: [left, top, width, height].
std::string box_script(const std::string& selector)
{
    return "(() => { const b = document.querySelector(" + Json(selector).dump() +
           ").getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()";
}

/// JavaScript that finds the place of an element in a page: [x, y], or words on why it cannot be pointed at. Pictures
/// that are loaded as they come near the window move what is below them, so the place is that of two frames after the
/// last of them is there.
std::string place_script(const std::string& selector, double across, double down)
{
    return "(async () => { const e = document.querySelector(" + Json(selector).dump() +
           ");"
           "if (!e) return 'there is no such element';"
           "const is_loading = () => [...document.images].some(i => { const r = i.getBoundingClientRect();"
           "  return !i.complete && i.offsetParent && r.bottom > -1000 && r.top < innerHeight + 1000; });"
           "for (let frames = 0, still = 0, before = NaN; still < 2 && frames < 100; ++frames) {"
           "  e.scrollIntoView({block: 'center', inline: 'center', behavior: 'instant'});"
           "  await new Promise(done => requestAnimationFrame(() => setTimeout(done)));"
           "  const top = e.getBoundingClientRect().top;"
           "  still = top === before && !is_loading() ? still + 1 : 0;"
           "  before = top;"
           "}"
           "const b = e.getBoundingClientRect();"
           "if (b.width === 0 || b.height === 0) return 'it is not shown';"
           "const x = b.left + b.width * " +
           std::to_string(across) + ", y = b.top + b.height * " + std::to_string(down) +
           ";"
           "const hit = document.elementFromPoint(x, y);"
           "if (!hit || !(e.contains(hit) || hit.closest('label')?.control === e))"
           "  return 'at ' + x + ', ' + y + ' there is ' + (hit ? hit.outerHTML.slice(0, 200) : 'nothing');"
           "return [x, y]; })()";
}

/// "message (file:line)" of an exception's details.
std::string exception_text(const Json& details)
{
    std::string text = details.value("text", "");
    if (details.contains("exception")) text += " " + details["exception"].value("description", "");
    return text + " (" + details.value("url", "") + ":" + std::to_string(details.value("lineNumber", -1) + 1) + ")";
}

}

std::string from_base64(const std::string& text)
{
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const auto value = alphabet.find(c);
        if (value == std::string_view::npos) break; // "=": the end
        bits = bits << 6 | static_cast<unsigned>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

Browser::Browser(std::chrono::milliseconds limit)
    : pipe_(limit, [this](const std::string& method, const Json& event) { handle(method, event); })
{
    const auto target = pipe_.command("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    pipe_.use_session(pipe_.command("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"]);
    for (const char* domain : {"Page", "Runtime", "Log", "Network"}) pipe_.command(std::string(domain) + ".enable");
    resize(1280, 800);
}

void Browser::handle_console(const Json& event)
{
    std::string text = "console." + event.value("type", "") + ":";
    for (const auto& argument : event["args"]) {
        const auto& value = argument.contains("value") ? argument["value"] : argument["description"];
        text += " " + (value.is_string() ? value.get<std::string>() : value.dump());
    }
    messages_.push_back(text);
}

void Browser::handle(const std::string& method, const Json& event)
{
    if (method == "Page.loadEventFired") loaded_ = true;
    if (method == "Runtime.consoleAPICalled") handle_console(event);
    if (method == "Runtime.exceptionThrown") messages_.push_back(exception_text(event["exceptionDetails"]));
    if (method == "Log.entryAdded" && !is_of_software_graphics(event["entry"].value("text", "")))
        messages_.push_back("log: " + event["entry"].value("text", "") + " " + event["entry"].value("url", ""));
    if (method == "Network.requestWillBeSent") {
        const std::string url = event["request"]["url"];
        urls_.emplace_back(event["requestId"], url);
        if (!is_local(url)) requests_.push_back(url);
    }
    if (method == "Network.loadingFailed" && !event.value("canceled", false)) {
        const auto known = std::ranges::find(urls_, event["requestId"].get<std::string>(),
                                             &std::pair<std::string, std::string>::first);
        messages_.push_back("not loaded: " + (known == urls_.end() ? "" : known->second) + " " +
                            event.value("errorText", ""));
    }
}

void Browser::open(const std::filesystem::path& page, const std::string& fragment)
{
    // The browser starts from a blank page: what the page before still says is not taken for this one's.
    const auto load = [&](const std::string& url) {
        loaded_ = false;
        const auto outcome = pipe_.command("Page.navigate", {{"url", url}});
        if (outcome.contains("errorText")) throw BrowserError(url + ": " + outcome["errorText"].get<std::string>());
        pipe_.wait_until([&] { return loaded_; }, url + " to load");
    };
    load("about:blank");
    messages_.clear();
    requests_.clear();
    urls_.clear();
    load(file_url(page) + (fragment.empty() ? "" : "#" + fragment));
    evaluate("document.fonts.ready.then(() => new Promise(done => requestAnimationFrame(() => setTimeout(done))))"
             ".then(() => true)");
}

Json Browser::evaluate(const std::string& expression)
{
    auto outcome = pipe_.command(
        "Runtime.evaluate",
        {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}, {"userGesture", true}});
    if (outcome.contains("exceptionDetails"))
        throw BrowserError(expression + ": " + exception_text(outcome["exceptionDetails"]));
    auto& result = outcome["result"];
    return result.contains("value") ? result["value"] : Json();
}

void Browser::mouse(const std::string& type, bool pressed)
{
    pipe_.command("Input.dispatchMouseEvent", {{"type", type},
                                               {"x", mouse_x_},
                                               {"y", mouse_y_},
                                               {"button", pressed ? "left" : "none"},
                                               {"clickCount", pressed ? 1 : 0}});
}

void Browser::point_at(const std::string& selector, double across, double down)
{
    const auto place = evaluate(place_script(selector, across, down));
    if (place.is_string()) throw BrowserError(selector + ": " + place.get<std::string>());
    mouse_x_ = place[0];
    mouse_y_ = place[1];
    mouse("mouseMoved", false);
}

void Browser::click(const std::string& selector, double across, double down)
{
    point_at(selector, across, down);
    mouse("mousePressed", true);
    mouse("mouseReleased", true);
}

void Browser::drag(const std::string& selector, double across, double to_across, double down, double to_down)
{
    point_at(selector, across, down);
    mouse("mousePressed", true);
    for (const double part : {0.5, 1.0}) {
        const Json box = evaluate(box_script(selector));
        mouse_x_ = box[0].get<double>() + box[2].get<double>() * std::lerp(across, to_across, part);
        mouse_y_ = box[1].get<double>() + box[3].get<double>() * std::lerp(down, to_down, part);
        pipe_.command("Input.dispatchMouseEvent",
                      {{"type", "mouseMoved"}, {"x", mouse_x_}, {"y", mouse_y_}, {"button", "left"}, {"buttons", 1}});
    }
    mouse("mouseReleased", true);
}

void Browser::pinch(const std::string& selector, const std::array<double, 2>& across,
                    const std::array<double, 2>& to_across)
{
    point_at(selector, across[0]);
    const Json box = evaluate(box_script(selector));
    const auto touch = [&](const char* type, double part) {
        Json points = Json::array();
        for (const int id : {0, 1})
            if (part >= 0)
                points.push_back(
                    {{"id", id},
                     {"x", box[0].get<double>() + box[2].get<double>() * std::lerp(across[id], to_across[id], part)},
                     {"y", box[1].get<double>() + box[3].get<double>() / 2}});
        pipe_.command("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
    };
    touch("touchStart", 0);
    for (const double part : {0.25, 0.5, 0.75, 1.0}) touch("touchMove", part);
    touch("touchEnd", -1);
}

void Browser::press(const std::string& key, bool shift)
{
    const Key k = key_of(key);
    Json event = {{"key", k.name},
                  {"code", k.code},
                  {"windowsVirtualKeyCode", k.number},
                  {"modifiers", shift ? 8 : 0},
                  {"type", k.text.empty() ? "rawKeyDown" : "keyDown"}};
    if (!k.text.empty()) event["text"] = k.text;
    pipe_.command("Input.dispatchKeyEvent", event);
    event["type"] = "keyUp";
    event.erase("text");
    pipe_.command("Input.dispatchKeyEvent", event);
}

void Browser::type(const std::string& text)
{
    for (const char c : text) press(c == ' ' ? "Space" : std::string(1, c));
}

void Browser::resize(int width, int height, bool mobile)
{
    pipe_.command("Emulation.setDeviceMetricsOverride",
                  {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", mobile}});
}

void Browser::emulate(const std::string& media, bool dark)
{
    const Json scheme = {{"name", "prefers-color-scheme"}, {"value", dark ? "dark" : "light"}};
    pipe_.command("Emulation.setEmulatedMedia", {{"media", media}, {"features", Json::array({scheme})}});
}

std::string Browser::screenshot()
{
    return from_base64(pipe_.command("Page.captureScreenshot", {{"format", "png"}})["data"].get<std::string>());
}

}
