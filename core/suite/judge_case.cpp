#include "texplorer/suite/judge_case.h"

#include "texplorer/base/further.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/compare/comparison.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/compare/picture_pair.h"
#include "texplorer/conform/judge.h"
#include "texplorer/conform/skip.h"
#include "texplorer/image/convert.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/rule_choice.h"
#include "texplorer/suite/stored_picture.h"
#include "texplorer/suite/suite_folder.h"
#include "texplorer/text/percent.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

namespace texplorer::suite {
namespace {

namespace fs = std::filesystem;

Image rgba8(const Image& image) {
    Image result = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    const auto bytes = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t i = 0; i < result.pixels.size() / 4; ++i) {
        const std::array<std::uint8_t, 4> color = rgbaOf(image.format, image.pixels.data() + i * bytes);
        std::ranges::transform(color, result.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i),
                               [](std::uint8_t each) { return std::byte{each}; });
    }
    return result;
}

/// A stored picture within a suite's folder.
Result<Image> readPicture(const fs::path& folder, const std::string& name) {
    const Result<fs::path> path = pathInside(folder, name);
    if (!path)
        return fail(path.error());
    const Result<StoredPicture> picture = readStoredPicture(*path);
    if (!picture)
        return fail(picture.error());
    return rgba8(picture->image);
}

/// Whether the mask, Rgba8, hides the pixel whose first byte is there.
bool isMasked(const Image& mask, std::size_t at) {
    PixelBytes pixel{};
    std::memcpy(pixel.data(), mask.pixels.data() + at, pixel.size());
    return texplorer::isMasked(pixel);
}

/// None where a case has no mask. One that hides all would let any picture pass, and any become a golden.
Result<std::optional<Image>> readMask(const fs::path& folder, const Settings& settings) {
    if (settings.mask.empty())
        return std::optional<Image>();
    Result<Image> mask = readPicture(folder, settings.mask);
    if (!mask)
        return fail(mask.error());
    std::size_t at = 0;
    while (at < mask->pixels.size() && isMasked(*mask, at))
        at += 4;
    if (at == mask->pixels.size())
        return fail(ErrorCode::OutOfRange, "the mask leaves no pixel to compare", inFile(settings.mask));
    return std::optional<Image>(*std::move(mask));
}

/// What doesn't count is as it was expected.
void takeMasked(Image& actual, const Image& expected, const Image& mask) {
    for (std::size_t i = 0; i < actual.pixels.size(); i += 4) {
        if (isMasked(mask, i))
            std::ranges::copy(ByteView(expected.pixels).subspan(i, 4),
                              actual.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

bool isSameSize(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height;
}

JudgedCase unjudged(CaseRecord record, const Error& error) {
    return {problemOf(std::move(record), error), {}, {}};
}

std::array<std::uint8_t, 4> colorAt(const Image& image, int x, int y) {
    std::array<std::uint8_t, 4> color{};
    std::ranges::transform(image.at(x, y), color.begin(),
                           [](std::byte each) { return std::to_integer<std::uint8_t>(each); });
    return color;
}

/// What a comparison of two pictures says.
JudgedCase judgedBy(CaseRecord record, const Criterion& criterion, const Comparison& comparison) {
    record.sentence = comparison.sentence;
    if (!comparison.sameSize()) {
        record.state = State::Resized;
        return {std::move(record), {}, {}};
    }
    record.metric = texplorer::rowOf(criterion.metric).name;
    record.tolerance = criterion.tolerance;
    record.share = criterion.share;
    record.state = comparison.alike ? State::Passed : State::Failed;
    record.score = comparison.score;
    record.shareOver = comparison.shareOver();
    record.pixels = comparison.pixels;
    record.over = comparison.over;
    const ComparedPixel& worst = comparison.worst;
    if (worst.value > 0)
        record.worst = {worst.at.x, worst.at.y, worst.expected, worst.actual};
    JudgedCase judged{std::move(record), {}, {}};
    if (!comparison.alike && !comparison.map.empty())
        judged.difference = comparison.map;
    return judged;
}

JudgedCase judgeStored(CaseRecord record, const Criterion& criterion, Image expected, const Image& actual,
                       const Image* mask, unsigned threads) {
    const ComparisonWork work{.map = true, .threads = threads, .stop = {}, .report = {}};
    const Result<Comparison> comparison = comparePictures(expected, actual, criterion, mask, work);
    if (!comparison)
        return unjudged(std::move(record), comparison.error());
    JudgedCase judged = judgedBy(std::move(record), criterion, *comparison);
    judged.expected = std::move(expected);
    return judged;
}

/// Where the driver made use of what OpenGL leaves open of rho.
Sentence rhoSentence(const conform::Judgement& judgement) {
    if (judgement.rho != reference::RhoMethod::Ideal)
        return Sentence("rho is at the {0} end of what OpenGL 2.1, section 3.8.8, allows (--rho {0})",
                        ProperName{texplorer::rowOf(judgement.rho).name});
    if (judgement.withinRho > 0)
        return Sentence("{0} by a rho within what OpenGL 2.1, section 3.8.8, allows",
                        Sentence::plural("{0} pixel", "{0} pixels", judgement.withinRho));
    return {};
}

Sentence ruleSentence(const conform::Rule& rule, const conform::Judgement& judgement) {
    const Difference& difference = judgement.difference;
    const auto share = [&difference](std::size_t pixels) {
        return percentText(static_cast<double>(pixels) / static_cast<double>(difference.pixels));
    };
    const ProperName name{rule.name};
    if (difference.max == 0)
        return N_("it equals the reference's picture in every byte");
    if (difference.over == 0)
        return Sentence("no pixel differs by more than {0}/255 from the reference, by the rule {1}",
                        rule.bound, name);
    const Sentence over = Sentence::plural("{0} pixel ({1}) differs by more than {2}/255 from the reference",
                                           "{0} pixels ({1}) differ by more than {2}/255 from the reference",
                                           difference.over, ProperName{share(difference.over)}, rule.bound);
    const auto upTo = [](double near) {
        return near < 1 ? Sentence("up to {0}", ProperName{percentText(1 - near)}) : Sentence(N_("none"));
    };
    const Sentence allowed = upTo(rule.explainedScene);
    const auto further = [&over](const Sentence& sentence) { return Sentence(furtherKey, over, sentence); };
    if (judgement.shareFar() > 1 - rule.nearScene)
        return further(Sentence("{0} ({1}) by more than {2}/255, of which the rule {3} allows {4}",
                                Sentence::plural("{0} pixel", "{0} pixels", judgement.far),
                                ProperName{share(judgement.far)}, rule.farBound, name, upTo(rule.nearScene)));
    if (rule.tolerance == conform::Tolerance::None)
        return further(Sentence("the rule {0} allows {1}", name, allowed));
    if (judgement.unexplained == 0)
        return further(difference.over == 1 ? Sentence("the rule {0} explains it", name)
                                            : Sentence("the rule {0} explains all of them", name));
    return further(Sentence("the rule {0} explains all but {1} of them ({2}), and allows {3}", name,
                            judgement.unexplained, ProperName{share(judgement.unexplained)}, allowed));
}

JudgedCase judgeByRule(CaseRecord record, const conform::Rule& rule, const Scene& scene, Image expected,
                       const Image& actual, conform::Explainer& reference, conform::RhoRange range) {
    Result<conform::Judgement> judgement = conform::judge(rule, scene, expected, actual, reference, range);
    if (!judgement)
        return unjudged(std::move(record), judgement.error());
    if (judgement->redrawn)
        expected = *std::move(judgement->redrawn);
    const Difference& difference = judgement->difference;
    record.metric = fmt::format("rule {}", rule.name);
    record.score = difference.mean;
    record.tolerance = rule.bound;
    record.share = 1 - rule.explainedScene;
    record.shareOver = difference.shareOver();
    record.pixels = difference.pixels;
    record.over = difference.over;
    record.unexplained = judgement->unexplained;
    record.state = judgement->isAllowed(rule) ? State::Passed : State::Failed;
    record.sentence = ruleSentence(rule, *judgement);
    if (const Sentence rho = rhoSentence(*judgement); !rho.empty())
        record.sentence = Sentence(furtherKey, record.sentence, rho);
    if (difference.max > 0) {
        const auto [x, y] = std::array{difference.worst.x, difference.worst.y};
        record.worst = {x, expected.height - 1 - y, colorAt(expected, x, y), colorAt(actual, x, y)};
    }
    JudgedCase judged{std::move(record), {}, {}};
    if (judged.record.state == State::Failed) {
        Result<Image> map = heatMap(expected, actual, {.tolerance = rule.bound, .top = 255});
        if (map)
            judged.difference = *std::move(map);
    }
    judged.expected = std::move(expected);
    return judged;
}

JudgedCase judgeAgainstReference(CaseRecord record, const Settings& settings, const Case& of,
                                 const CaseScene& scene, const Image& actual,
                                 const std::optional<Image>& mask, const conform::Driver& driver,
                                 unsigned threads) {
    record.golden = "reference";
    const auto reference = conform::referenceRendererFor({.scene = {},
                                                          .images = scene.images,
                                                          .time = of.time,
                                                          .width = of.size.width,
                                                          .height = of.size.height,
                                                          .anisotropy = driver.anisotropy()},
                                                         threads);
    Result<Frame> frame = reference->draw(scene.scene);
    if (!frame)
        return unjudged(std::move(record), frame.error());
    const conform::RhoRange range = conform::rhoRangeOf(driver);
    const std::string& name = std::get<GoldenReference>(settings.golden).rule;
    const conform::Rule* rule = name == "auto" ? &ruleFor(scene.scene) : findRule(name);
    if (!rule)
        return judgeStored(std::move(record), settings.criterion, std::move(frame->image), actual,
                           mask ? &*mask : nullptr, threads);
    if (mask && !isSameSize(*mask, frame->image))
        return unjudged(std::move(record),
                        {ErrorCode::OutOfRange,
                         Sentence("expected a mask of {0} × {1} pixels, found {2} × {3}", of.size.width,
                                  of.size.height, mask->width, mask->height),
                         inFile(settings.mask)});
    if (!mask || !isSameSize(frame->image, actual))
        return judgeByRule(std::move(record), *rule, scene.scene, std::move(frame->image), actual, *reference,
                           range);
    Image counted = actual;
    takeMasked(counted, frame->image, *mask);
    return judgeByRule(std::move(record), *rule, scene.scene, std::move(frame->image), counted, *reference,
                       range);
}

/// Nearer: the same size rather than another, then less that is over the tolerance, then a better worst
/// pixel.
bool isNearer(const JudgedCase& a, const JudgedCase& b) {
    const auto rank = [](const JudgedCase& each) {
        return each.record.state == State::Error ? 2 : each.record.state == State::Resized ? 1 : 0;
    };
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.record.shareOver < b.record.shareOver;
}

JudgedCase judgeAgainstFiles(const CaseRecord& record, const fs::path& folder, const Settings& settings,
                             const std::vector<std::string>& goldens, const Image& actual,
                             const std::optional<Image>& mask, unsigned threads) {
    std::optional<JudgedCase> nearest;
    for (const std::string& golden : goldens) {
        CaseRecord own = record;
        own.golden = golden;
        Result<Image> expected = readPicture(folder, golden);
        if (!expected && expected.error().code == ErrorCode::NotFound)
            continue;
        JudgedCase judged = expected ? judgeStored(std::move(own), settings.criterion, *std::move(expected),
                                                   actual, mask ? &*mask : nullptr, threads)
                                     : unjudged(std::move(own), expected.error());
        judged.goldenIsBroken = !expected && isNoPicture(expected.error());
        if (judged.record.state == State::Passed)
            return judged;
        if (!nearest || isNearer(judged, *nearest))
            nearest = std::move(judged);
    }
    if (nearest)
        return *std::move(nearest);
    JudgedCase judged{record, {}, {}};
    judged.record.state = State::New;
    judged.record.golden = goldens.empty() ? std::string() : goldens.front();
    judged.record.sentence = goldens.empty()
                                 ? Sentence(N_("there is no golden for this driver"))
                                 : Sentence("there is no golden yet: {0}", ProperName{goldens.front()});
    return judged;
}

} // namespace

reference::AnisotropyMethod anisotropyOf(const Golden& golden, const conform::Driver& driver) {
    return std::holds_alternative<GoldenReference>(golden) ? driver.anisotropy()
                                                           : reference::DrawRequest().anisotropy;
}

CaseRecord recordOf(const Plan& plan, const Case& of, State state, Sentence sentence) {
    CaseRecord record{.name = of.name, .state = state, .sentence = std::move(sentence)};
    record.renderer = texplorer::rowOf(of.renderer).name;
    record.width = of.size.width;
    record.height = of.size.height;
    record.time = of.time;
    if (std::holds_alternative<GoldenReference>(plan.settingsOf(of).golden))
        record.golden = "reference";
    return record;
}

std::optional<CaseRecord> recordWithoutDrawing(const Plan& plan, const Case& of) {
    if (!of.problem)
        return {};
    const State state = of.problem->code == ErrorCode::NotFound ? State::MissingScene : State::Error;
    return problemOf(recordOf(plan, of, state, {}), *of.problem, state);
}

std::optional<CaseRecord> recordWithoutDrawing(const Plan& plan, const Case& of, const CaseScene& scene,
                                               const conform::Driver& driver) {
    if (!std::holds_alternative<GoldenReference>(plan.settingsOf(of).golden))
        return {};
    const conform::Pair pair{of.renderer, RendererKind::Reference};
    const conform::Skip* skip =
        of.renderer == RendererKind::Reference ? nullptr : conform::skipOf(scene.scene, pair, driver);
    if (!skip)
        return {};
    CaseRecord record = recordOf(plan, of, State::Skipped, skip->reason);
    record.driver = driver.name;
    return record;
}

JudgedCase judgeCase(const Plan& plan, const Case& of, const CaseScene& scene, const Image& actual,
                     const conform::Driver& driver, unsigned threads) {
    if (std::optional<CaseRecord> skipped = recordWithoutDrawing(plan, of, scene, driver))
        return {*std::move(skipped), {}, {}};
    const Settings& settings = plan.settingsOf(of);
    const fs::path& folder = plan.suiteOf(of).folder;
    CaseRecord record = recordOf(plan, of, State::Error, {});
    record.driver = driver.name;
    const Result<std::optional<Image>> mask = readMask(folder, settings);
    if (!mask)
        return unjudged(std::move(record), mask.error());
    if (std::holds_alternative<GoldenReference>(settings.golden))
        return judgeAgainstReference(std::move(record), settings, of, scene, actual, *mask, driver, threads);
    return judgeAgainstFiles(record, folder, settings, goldensOf(plan, of, driver.name), actual, *mask,
                             threads);
}

JudgedCase judgePictures(const Criterion& criterion, const std::string& name, const Image& expected,
                         const Image& actual, const Image* mask, unsigned threads) {
    CaseRecord record{.name = name, .state = State::Error, .golden = name};
    record.width = actual.width;
    record.height = actual.height;
    return judgeStored(std::move(record), criterion, rgba8(expected), actual, mask, threads);
}

} // namespace texplorer::suite
