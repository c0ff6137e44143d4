#include "texplorer/lesson/numbers.h"

#include "texplorer/reference/explain/sampling_steps.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer::lesson {
namespace {

using reference::Explanation;
using reference::FragmentExplanation;
using reference::UnitExplanation;

std::string colorText(glm::vec4 color) {
    return fmt::format("({:.3g}, {:.3g}, {:.3g}, {:.3g})", color.r, color.g, color.b, color.a);
}

std::string levelsText(const std::vector<reference::LevelShare>& shares) {
    std::string levels;
    for (const reference::LevelShare& share : shares)
        levels += fmt::format("{}{}", levels.empty() ? "" : ", ", share.level);
    return levels;
}

/// A word is about the pixel, with the fragment that is seen there, or about that fragment's first unit.
struct Word {
    std::string_view name;
    std::string (*ofPixel)(const Explanation& explanation, const FragmentExplanation& seen);
    std::string (*ofUnit)(const UnitExplanation& unit);
};

constexpr std::array words{
    Word{"color",
         [](const Explanation& explanation, const FragmentExplanation&) {
             const reference::PixelBytes& bytes = explanation.bytes;
             return fmt::format("({}, {}, {})", bytes[0], bytes[1], bytes[2]);
         },
         nullptr},
    Word{"fragment",
         [](const Explanation&, const FragmentExplanation& seen) { return colorText(seen.primary); },
         nullptr},
    Word{"s", nullptr, [](const UnitExplanation& unit) { return fmt::format("{:.3g}", unit.coords.x); }},
    Word{"t", nullptr, [](const UnitExplanation& unit) { return fmt::format("{:.3g}", unit.coords.y); }},
    Word{"side", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.lengthX); }},
    Word{"up", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.lengthY); }},
    Word{"rho", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.rho); }},
    Word{"lambda", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{:.2f}", unit.sample.lod.lambda); }},
    Word{"level", nullptr, [](const UnitExplanation& unit) { return levelsText(unit.sample.levels); }},
    Word{"probes", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{}", unit.sample.lod.probes); }},
    Word{"texels", nullptr,
         [](const UnitExplanation& unit) { return fmt::format("{}", reference::texelCount(unit.sample)); }},
    Word{"texel", nullptr, [](const UnitExplanation& unit) { return colorText(unit.sample.color); }},
};

/// The next word in braces from `at` on; npos: none.
struct Place {
    std::size_t begin;
    std::size_t end; ///< behind the brace
    std::string_view name;
};

Place nextPlace(std::string_view text, std::size_t at) {
    const std::size_t begin = text.find('{', at);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('}', begin);
    if (end == std::string_view::npos)
        return {std::string_view::npos, std::string_view::npos, {}};
    return {begin, end + 1, text.substr(begin + 1, end - begin - 1)};
}

std::size_t indexOf(std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(words, name, &Word::name) - words.begin());
}

bool hasWords(const Step& step) {
    return std::ranges::any_of(textsOf(step), [](const std::string& text) { return !wordsIn(text).empty(); });
}

} // namespace

reference::PixelPlace pixelOf(int x, int y, PictureSize picture) {
    constexpr int whole = 1000;
    constexpr int across = 4; // the lessons' pictures are 4:3
    constexpr int upwards = 3;
    const int column =
        (picture.width * whole * upwards / 2 + (x - whole / 2) * picture.height * across) / (whole * upwards);
    return {std::clamp(column, 0, std::max(0, picture.width - 1)),
            std::max(0, picture.height - 1 - y * picture.height / whole)};
}

reference::PixelPlace pixelOf(reference::PixelPlace pixel, PictureSize from, PictureSize to, double zoom) {
    const double scale = zoom * to.height / std::max(1, from.height);
    const auto placed = [scale](int at, int before, int now) { // the middles of pixels, from the centre
        const double moved = now / 2.0 + (at + 0.5 - before / 2.0) * scale;
        return static_cast<int>(std::clamp(std::floor(moved), 0.0, std::max(0.0, now - 1.0)));
    };
    return {placed(pixel.x, from.width, to.width), placed(pixel.y, from.height, to.height)};
}

Numbers::Numbers(std::string_view sign)
    : sign_(sign) {}

Numbers::Numbers(const Explanation& explanation)
    : values_(words.size()) {
    const FragmentExplanation* seen = explanation.seen();
    if (!seen)
        return;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Word& word = words[i];
        if (word.ofPixel)
            values_[i] = word.ofPixel(explanation, *seen);
        else if (!seen->units.empty())
            values_[i] = word.ofUnit(seen->units.front());
    }
}

std::string_view Numbers::of(std::string_view word) const {
    const std::size_t index = indexOf(word);
    return index < values_.size() ? std::string_view(values_[index]) : std::string_view();
}

std::string Numbers::in(std::string_view text) const {
    std::string filled;
    std::size_t from = 0;
    for (Place place = nextPlace(text, 0); place.begin != std::string_view::npos;
         place = nextPlace(text, place.end)) {
        const std::string_view number = of(place.name);
        filled.append(text.substr(from, place.begin - from)).append(number.empty() ? sign_ : number);
        from = place.end;
    }
    return filled.append(text.substr(from));
}

Result<Numbers> numbersOf(const LessonScene& scene, const Look& look, PictureSize picture,
                          std::stop_token stop) {
    if (look.probeX < 0)
        return Numbers();
    reference::DrawOptions options;
    options.stop = std::move(stop);
    return reference::probe({scene.scene, scene.images, 0, picture.width, picture.height},
                            pixelOf(look.probeX, look.probeY, picture), options)
        .map([](const Explanation& explanation) { return Numbers(explanation); });
}

Result<StepNumbers> numbersOf(const LessonScene& start, const Step& step, PictureSize picture,
                              std::stop_token stop) {
    if (!hasWords(step))
        return StepNumbers{};
    const auto* predict = std::get_if<Predict>(&step.task);
    Result<Numbers> atStart = numbersOf(start, step.look, picture, stop);
    if (!atStart || !predict)
        return atStart.map([](const Numbers& numbers) { return StepNumbers{numbers, numbers}; });
    return withEdits(start, predict->answers[predict->right].edits)
        .and_then([&](const LessonScene& answered) { return numbersOf(answered, step.look, picture, stop); })
        .map([&](const Numbers& answered) {
            return StepNumbers{*atStart, answered};
        });
}

std::vector<std::string_view> wordsIn(std::string_view text) {
    std::vector<std::string_view> names;
    for (Place place = nextPlace(text, 0); place.begin != std::string_view::npos;
         place = nextPlace(text, place.end))
        names.push_back(place.name);
    return names;
}

Result<void> checkWords(std::string_view text) {
    for (const std::string_view name : wordsIn(text)) {
        if (indexOf(name) < words.size())
            continue;
        std::string names;
        for (const Word& word : words)
            names += fmt::format("{}{{{}}}", names.empty() ? "" : ", ", word.name);
        return fail(ErrorCode::Malformed, Sentence("expected one of {0}, found {1}", ProperName{names},
                                                   ProperName{inQuotes(fmt::format("{{{}}}", name))}));
    }
    return {};
}

} // namespace texplorer::lesson
