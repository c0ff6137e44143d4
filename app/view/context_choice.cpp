#include "app/view/context_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace texplorer::view {
namespace {

struct ContextWord {
    std::string_view word;
    ContextChoice::Kind kind;
};

constexpr std::array contextWords{ContextWord{"auto", ContextChoice::Kind::Auto},
                                  ContextWord{"osmesa", ContextChoice::Kind::Osmesa},
                                  ContextWord{"egl", ContextChoice::Kind::Egl},
                                  ContextWord{"egl:surfaceless", ContextChoice::Kind::EglSurfaceless}};
constexpr std::string_view devicePrefix = "egl:";

} // namespace

Result<ContextChoice> ContextChoice::parse(std::string_view text, std::string_view where) {
    const auto* found = std::ranges::find(contextWords, text, &ContextWord::word);
    if (found != contextWords.end())
        return ContextChoice{found->kind, 0};
    if (text.starts_with(devicePrefix)) {
        ContextChoice choice{Kind::EglDevice, 0};
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + devicePrefix.size(), end, choice.device);
        if (error == std::errc() && stop == end && choice.device >= 0)
            return choice;
    }
    return fail(ErrorCode::OutOfRange,
                Sentence("expected auto, osmesa, egl, egl:surfaceless or egl:N with the number of a "
                         "device, found \"{0}\"",
                         text),
                atOption(std::string(where)));
}

std::string ContextChoice::text() const {
    if (kind == Kind::EglDevice)
        return fmt::format("{}{}", devicePrefix, device);
    return std::string(std::ranges::find(contextWords, kind, &ContextWord::kind)->word);
}

} // namespace texplorer::view
