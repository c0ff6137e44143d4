#include "texplorer/lesson/mark_check.h"

#include "texplorer/lesson/lesson_place.h"
#include "texplorer/lesson/match.h"
#include "texplorer/lesson/numbers.h"
#include "texplorer/reference/draw.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace texplorer::lesson {
namespace {

using reference::blendsLevels;
using reference::Explanation;
using reference::FragmentExplanation;
using reference::isLinear;
using reference::UnitExplanation;
using reference::wantsMipmaps;

/// Next to a question, on a page, in a window of 1280 x 800. Where a side is odd, a pixel's centre is in the
/// middle of the picture.
constexpr std::array triedSizes{PictureSize{smallWidth, smallHeight}, pageSize, PictureSize{583, 402},
                                PictureSize{401, 301}};

/// How near to equal two choices have to be for renderers that round otherwise to part.
constexpr double nearTexels = 1.0 / 128;
constexpr double nearLambda = 0.02;

/// The marked pixel of a scene in a picture of each size.
using Marked = std::vector<Explanation>;

std::string sizeOf(const Explanation& explanation) {
    return fmt::format("{} × {}", explanation.width, explanation.height);
}

Result<Marked> markedIn(const LessonScene& scene, const Look& look) {
    reference::ReferenceRenderer renderer;
    Marked marked;
    for (const PictureSize& size : triedSizes) {
        Result<Explanation> explanation = renderer.probe(
            {scene.scene, scene.images, 0, size.width, size.height}, pixelOf(look.probeX, look.probeY, size));
        if (!explanation)
            return fail(explanation.error());
        marked.push_back(*std::move(explanation));
    }
    return marked;
}

/// At its ends a repeated image goes on with another texel, and GL_CLAMP and GL_MIRRORED_REPEAT with the
/// same.
bool isEnd(const UnitExplanation& unit, const reference::WrappedCoordinate& at) {
    const auto extent = std::ranges::find(unit.extents, at.level, &reference::LevelExtent::level);
    const double size = extent == unit.extents.end() ? 0 : extent->size[at.axis];
    const double edge = std::round(static_cast<double>(at.texels));
    return (at.wrap == Wrap::Clamp || at.wrap == Wrap::MirroredRepeat) && (edge <= 0 || edge >= size);
}

/// What is between two texels or levels, of which only one is read; empty: nothing.
Sentence tieOf(const UnitExplanation& unit) {
    const reference::Lod& lod = unit.sample.lod;
    const bool linearMag = unit.sampler.magFilter == MagFilter::Linear;
    const MinFilter min = unit.sampler.minFilter;
    const auto lambda = static_cast<double>(lod.lambda);
    if (linearMag != isLinear(min) && std::abs(lambda - static_cast<double>(lod.switchOver)) < nearLambda)
        return Sentence("lambda = {0:.3f} is between magnification and minification", lambda);
    if (!lod.magnified && wantsMipmaps(min) && !blendsLevels(min) &&
        std::abs(lambda - std::floor(lambda) - 0.5) < nearLambda)
        return Sentence("lambda = {0:.3f} is between two levels", lambda);
    if (lod.magnified ? linearMag : isLinear(min))
        return {};
    for (const reference::WrappedCoordinate& at : unit.sample.wrapped) {
        const auto texels = static_cast<double>(at.texels);
        if (std::abs(texels - std::round(texels)) < nearTexels && !isEnd(unit, at))
            return Sentence("{0} = {1:.3f} texels is between two texels", "stp"[at.axis], texels);
    }
    return {};
}

/// Each kind of mistake once: other sizes have it as well.
void checkPlace(const Marked& marked, const std::string& whose, const std::string& where,
                std::vector<Error>& problems) {
    const auto empty =
        std::ranges::find_if(marked, [](const Explanation& each) { return each.seen() == nullptr; });
    if (empty != marked.end())
        problems.push_back(
            {ErrorCode::OutOfRange,
             Sentence("nothing is drawn at the mark, in {0} of {1}", whose, ProperName{sizeOf(*empty)}),
             atPointer(where)});
    for (const Explanation& each : marked) {
        const FragmentExplanation* seen = each.seen();
        for (std::size_t i = 0; seen && i < seen->units.size(); ++i) {
            const Sentence tie = tieOf(seen->units[i]);
            if (!tie.empty())
                return problems.push_back({ErrorCode::OutOfRange,
                                           Sentence("at the mark {0}, in {1} of {2}: renderers may round "
                                                    "it differently",
                                                    tie, whose, ProperName{sizeOf(each)}),
                                           atPointer(where)});
        }
    }
}

struct PlacedText {
    std::string where;
    const std::string* text;
    const Marked* marked;
};

std::vector<PlacedText> placedTexts(const Step& step, const std::string& place, const Marked& start,
                                    const Marked& answered) {
    std::vector<PlacedText> texts{{place + "/title", &step.title, &start},
                                  {place + "/text", &step.text, &start}};
    if (const auto* task = std::get_if<Try>(&step.task))
        texts.push_back({place + "/try", &task->task, &start});
    if (const auto* match = std::get_if<Match>(&step.task))
        texts.push_back({place + "/match/task", &match->task, &start});
    if (const auto* predict = std::get_if<Predict>(&step.task)) {
        texts.push_back({place + "/predict/question", &predict->question, &start});
        for (std::size_t i = 0; i < predict->answers.size(); ++i)
            texts.push_back(
                {fmt::format("{}/predict/answers/{}/text", place, i), &predict->answers[i].text, &start});
        texts.push_back({place + "/predict/reason", &predict->reason, &answered});
    }
    return texts;
}

void checkWordsHaveNumbers(const PlacedText& text, std::vector<Error>& problems) {
    if (const Result<void> known = checkWords(*text.text); !known)
        return problems.push_back(at(text.where, known.error()));
    for (const std::string_view word : wordsIn(*text.text)) {
        if (text.marked->empty())
            return problems.push_back(
                {ErrorCode::NotFound,
                 Sentence("{{{0}}} is a number of the mark, but look has no probe", ProperName{word}),
                 atPointer(text.where)});
        for (const Explanation& each : *text.marked) {
            if (Numbers(each).of(word).empty())
                return problems.push_back(
                    {ErrorCode::NotFound,
                     Sentence("{{{0}}} has no number at the mark, in the picture of {1}", ProperName{word},
                              ProperName{sizeOf(each)}),
                     atPointer(text.where)});
        }
    }
}

/// As a number of its own: "7.1" isn't in "17.1" and "7.13".
bool hasNumber(std::string_view text, std::string_view number) {
    const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    for (std::size_t i = text.find(number); i != std::string_view::npos; i = text.find(number, i + 1)) {
        const std::size_t end = i + number.size();
        const bool begins = i == 0 || (!isDigit(i - 1) && text[i - 1] != '.' && text[i - 1] != '-');
        const bool ends = !isDigit(end) && !(end < text.size() && text[end] == '.' && isDigit(end + 1));
        if (begins && ends)
            return true;
    }
    return false;
}

/// The forms in which a text may contain it: as it is, and a length or lambda with one decimal place, except
/// for integers and halves, which are common for other reasons.
std::vector<std::string> typedForms(std::string_view number) {
    std::vector<std::string> forms{std::string(number)};
    double value = 0;
    const char* const end = number.data() + number.size();
    if (std::from_chars(number.data(), end, value).ptr != end || value < 1)
        return forms;
    const std::string tenths = fmt::format("{:.1f}", value);
    if (tenths.back() != '0' && tenths.back() != '5')
        forms.push_back(tenths);
    return forms;
}

/// s and t are left out: what is said of a place holds near it. So are whole numbers: they are there by
/// chance.
void checkTypedNumbers(const PlacedText& text, std::vector<Error>& problems) {
    constexpr std::array<std::string_view, 7> sized{"side",  "up",    "rho",     "lambda",
                                                    "color", "texel", "fragment"};
    for (const std::string_view word : sized) {
        for (const Explanation& each : *text.marked) {
            const Numbers numbers(each);
            const std::string_view number = numbers.of(word);
            const auto other = std::ranges::find_if(
                *text.marked, [&](const Explanation& its) { return Numbers(its).of(word) != number; });
            if (number.empty() || other == text.marked->end())
                continue;
            for (const std::string& form : typedForms(number)) {
                if (hasNumber(*text.text, form))
                    return problems.push_back(
                        {ErrorCode::Malformed,
                         Sentence(
                             "{0} is {{{1}}} in a picture of {2}, but {3} in one of {4}: expected the word",
                             ProperName{form}, ProperName{word}, ProperName{sizeOf(each)},
                             ProperName{Numbers(*other).of(word)}, ProperName{sizeOf(*other)}),
                         atPointer(text.where)});
            }
        }
    }
}

} // namespace

void checkMark(const LessonScene& start, const Step& step, const std::string& place,
               std::vector<Error>& problems) {
    struct Shown {
        std::string_view whose;
        Result<LessonScene> scene;
        Marked marked{};
    };
    std::vector<Shown> shown{{"the step's picture", start}};
    if (const auto* predict = std::get_if<Predict>(&step.task))
        shown.push_back(
            {"the right answer's picture", withEdits(start, predict->answers[predict->right].edits)});
    if (const auto* match = std::get_if<Match>(&step.task))
        shown.push_back({"the picture to reach", withEdits(start, match->edits)});
    for (Shown& each : shown) {
        if (step.look.probeX < 0 || !each.scene) // said where the edits are
            continue;
        Result<Marked> marked = markedIn(*each.scene, step.look);
        if (!marked)
            return problems.push_back(at(place, marked.error()));
        each.marked = *std::move(marked);
        checkPlace(each.marked, std::string(each.whose), place + "/look/probe", problems);
    }
    for (const PlacedText& text : placedTexts(step, place, shown.front().marked, shown.back().marked)) {
        checkWordsHaveNumbers(text, problems);
        checkTypedNumbers(text, problems);
    }
}

} // namespace texplorer::lesson
