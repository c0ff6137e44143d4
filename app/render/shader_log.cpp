#include "app/render/shader_log.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace texplorer::render {

namespace {

/// A position in a source: Mesa and Intel write "0:12(5): error: …", NVIDIA "0(12) : error …", others "ERROR:
/// 0:12: …".
struct Place {
    int line = 0;
    std::size_t end = 0; ///< where the message begins
};

std::optional<Place> placeIn(std::string_view text) {
    const auto number = [text](std::size_t& at) {
        int value = -1;
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
        at = error == std::errc() ? static_cast<std::size_t>(stop - text.data()) : at;
        return error == std::errc() ? value : -1;
    };
    std::size_t at = 0;
    for (const std::string_view word : {"ERROR: ", "WARNING: "}) {
        if (text.starts_with(word))
            at = word.size();
    }
    if (number(at) < 0 || at >= text.size() || (text[at] != ':' && text[at] != '('))
        return std::nullopt;
    ++at;
    const int line = number(at);
    if (line < 1)
        return std::nullopt;
    if (at < text.size() && text[at] == '(') // a column
        at = std::min(text.find(')', at), text.size() - 1) + 1;
    while (at < text.size() && (text[at] == ')' || text[at] == ':' || text[at] == ' '))
        ++at;
    return Place{line, at};
}

} // namespace

std::vector<view::ShaderMessage> translateLog(std::string_view log, const glsl::StageSource& source,
                                              std::optional<view::ShaderStage> stage) {
    std::vector<view::ShaderMessage> messages;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        if (line.ends_with('\r') || line.ends_with('\0'))
            line.remove_suffix(1);
        if (line.empty())
            continue;
        const std::optional<Place> place = placeIn(line);
        if (place && static_cast<std::size_t>(place->line) <= source.lines.size()) {
            const glsl::SourceLine& from = source.lines[static_cast<std::size_t>(place->line - 1)];
            messages.push_back({stage, place->line,
                                fmt::format("{}:{}: {}", from.file, from.line, line.substr(place->end))});
        } else
            messages.push_back({stage, 0, std::string(line)});
    }
    return messages;
}

} // namespace texplorer::render
