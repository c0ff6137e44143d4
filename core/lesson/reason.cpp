#include "core/lesson/reason.h"

#include "core/lesson/match.h"
#include "core/reference/draw.h"
#include "core/reference/probe.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::lesson {
namespace {

using reference::Explanation;
using reference::FragmentExplanation;
using reference::UnitExplanation;

const UnitExplanation* unitOf(const Explanation& explanation) {
    const FragmentExplanation* seen = explanation.seen();
    return seen && !seen->units.empty() ? &seen->units.front() : nullptr;
}

std::string colorText(glm::vec4 color) {
    return fmt::format("({:.3g}, {:.3g}, {:.3g}, {:.3g})", color.r, color.g, color.b, color.a);
}

struct Word {
    std::string_view name;
    std::string (*text)(const Explanation& explanation, const FragmentExplanation& seen,
                        const UnitExplanation& unit);
};

constexpr std::array words{
    Word{"color",
         [](const Explanation& explanation, const FragmentExplanation&, const UnitExplanation&) {
             const auto& bytes = explanation.bytes;
             return fmt::format("({}, {}, {})", bytes[0], bytes[1], bytes[2]);
         }},
    Word{"s", [](const Explanation&, const FragmentExplanation&,
                 const UnitExplanation& unit) { return fmt::format("{:.3g}", unit.coords.x); }},
    Word{"t", [](const Explanation&, const FragmentExplanation&,
                 const UnitExplanation& unit) { return fmt::format("{:.3g}", unit.coords.y); }},
    Word{"level",
         [](const Explanation&, const FragmentExplanation&, const UnitExplanation& unit) {
             std::string levels;
             for (const reference::LevelShare& share : unit.sample.levels)
                 levels += fmt::format("{}{}", levels.empty() ? "" : ", ", share.level);
             return levels;
         }},
    Word{"lambda", [](const Explanation&, const FragmentExplanation&,
                      const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.lambda); }},
    Word{"rho", [](const Explanation&, const FragmentExplanation&,
                   const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.rho); }},
    Word{"texel", [](const Explanation&, const FragmentExplanation&,
                     const UnitExplanation& unit) { return colorText(unit.sample.color); }},
    Word{"texels", [](const Explanation&, const FragmentExplanation&,
                      const UnitExplanation& unit) { return fmt::format("{}", unit.sample.taps.size()); }},
    Word{"fragment", [](const Explanation&, const FragmentExplanation& seen,
                        const UnitExplanation&) { return colorText(seen.primary); }},
};

/// The next word in braces from `at` on; npos: none.
struct Place {
    std::size_t begin;
    std::size_t end; ///< behind the brace
    std::string_view name;
};

Place nextPlace(std::string_view reason, std::size_t at) {
    const std::size_t begin = reason.find('{', at);
    const std::size_t end = begin == std::string_view::npos ? begin : reason.find('}', begin);
    if (end == std::string_view::npos)
        return {std::string_view::npos, std::string_view::npos, {}};
    return {begin, end + 1, reason.substr(begin + 1, end - begin - 1)};
}

const Word* findWord(std::string_view name) {
    const auto* found = std::ranges::find(words, name, &Word::name);
    return found == words.end() ? nullptr : found;
}

} // namespace

Result<void> checkReason(std::string_view reason) {
    for (Place place = nextPlace(reason, 0); place.begin != std::string_view::npos;
         place = nextPlace(reason, place.end)) {
        if (findWord(place.name))
            continue;
        std::string names;
        for (const Word& word : words)
            names += fmt::format("{}{{{}}}", names.empty() ? "" : ", ", word.name);
        return fail(ErrorCode::Malformed,
                    fmt::format("expected one of {}, found \"{{{}}}\"", names, place.name));
    }
    return {};
}

Result<std::string> reasonOf(std::string_view reason, const LessonScene& scene, int x, int y) {
    if (nextPlace(reason, 0).begin == std::string_view::npos)
        return std::string(reason);
    constexpr int whole = 1000;
    const reference::PixelPlace pixel{x * smallWidth / whole, smallHeight - 1 - y * smallHeight / whole};
    Result<Explanation> explanation =
        x < 0 ? Result<Explanation>(Explanation{})
              : reference::probe({scene.scene, scene.images, 0, smallWidth, smallHeight}, pixel);
    if (!explanation)
        return fail(explanation.error());
    const FragmentExplanation* seen = explanation->seen();
    const UnitExplanation* unit = unitOf(*explanation);
    std::string text;
    std::size_t from = 0;
    for (Place place = nextPlace(reason, 0); place.begin != std::string_view::npos;
         place = nextPlace(reason, place.end)) {
        const Word* word = findWord(place.name);
        text += reason.substr(from, place.begin - from);
        text += word && seen && unit ? word->text(*explanation, *seen, *unit) : "–";
        from = place.end;
    }
    return text + std::string(reason.substr(from));
}

} // namespace texplorer::lesson
