#include "app/screenshot/arguments/criterion_argument.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/output.h"
#include "texplorer/base/further.h"
#include "texplorer/base/sentence.h"
#include "texplorer/compare/comparison.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

// As of cmp(1): what can't be told has a status of its own.
constexpr int picturesAreAlike = 0;
constexpr int picturesDiffer = 1;
constexpr ExitCode picturesUnknown = wrongCall;

struct CompareOptions {
    std::string expected;
    std::string actual;
    std::vector<std::string> pictures; ///< both, where they have no names
    CriterionArgument criterion;
    std::string out;
    bool json = false;
};

/// The base level of a file that holds one picture, its bottom row first.
struct ReadPicture {
    Image image;
    int componentBits = 8; ///< as the file has them
};

Result<ReadPicture> readPicture(const std::string& path) {
    Result<TextureImage> file = readTexture(path);
    if (!file)
        return fail(file.error());
    const Surface& base = file->surface(0, 0);
    for (const auto& [count, part] : {std::pair{file->layers, Sentence::Key<int>("{0} layers")},
                                      std::pair{file->faces, Sentence::Key<int>("{0} faces")},
                                      std::pair{depthOf(base), Sentence::Key<int>("{0} slices")}})
        if (count > 1)
            return fail(ErrorCode::Unsupported,
                        Sentence("expected one picture, found {0}; texshot decode extracts one",
                                 Sentence(part, count)),
                        inFile(path));
    const int bits = file->componentBits;
    Result<Image> image = uprightImage(*std::move(file));
    if (!image)
        return fail(image.error());
    return ReadPicture{*std::move(image), bits};
}

Json sizeJson(const glm::ivec2& size) {
    return {{"width", size.x}, {"height", size.y}};
}

Json rectJson(const PixelRect& rect) {
    return {{"x", rect.x}, {"y", rect.y}, {"width", rect.width}, {"height", rect.height}};
}

/// What only pictures of one size have.
void addNumbers(Json& document, const Comparison& comparison) {
    document["pixels"] = comparison.pixels;
    document["over"] = comparison.over;
    document["shareOver"] = comparison.shareOver();
    document["score"] = comparison.score;
    const ComparedPixel& worst = comparison.worst;
    document["worst"] = worst.value > 0 ? Json{{"x", worst.at.x},
                                               {"y", worst.at.y},
                                               {"value", worst.value},
                                               {"expected", worst.expected},
                                               {"actual", worst.actual}}
                                        : Json();
    document["bounds"] = comparison.over > 0 ? rectJson(comparison.bounds) : Json();
    document["regions"] = comparison.regions;
    Json largest = Json::array();
    for (const DifferentRegion& region : comparison.largest) {
        largest.push_back(rectJson(region.bounds));
        largest.back()["pixels"] = region.pixels;
    }
    document["largestRegions"] = std::move(largest);
    document["difference"] = {{"max", comparison.difference.max}, {"mean", comparison.difference.mean}};
}

/// What is said where a file has more than is compared; empty: none has.
std::string depthNote(int componentBits) {
    return componentBits > 8
               ? fmt::format("{} bits a component: they are rounded to 8 for the comparison", componentBits)
               : std::string();
}

std::string comparisonJson(const CompareOptions& options, const Comparison& comparison,
                           const std::string& note) {
    const Criterion& criterion = comparison.criterion;
    Json document{{"alike", comparison.alike},
                  {"id", firstIdJson(comparison.sentence)},
                  {"sentence", comparison.sentence.english()},
                  {"expected", options.expected},
                  {"actual", options.actual},
                  {"metric", rowOf(criterion.metric).name},
                  {"tolerance", criterion.tolerance},
                  {"share", criterion.share},
                  {"components", criterion.compared == Compared::Rgba ? "rgba" : "rgb"},
                  {"expectedSize", sizeJson(comparison.expectedSize)},
                  {"actualSize", sizeJson(comparison.actualSize)}};
    if (!note.empty())
        document["note"] = note;
    if (!options.criterion.mask.empty())
        document["mask"] = options.criterion.mask;
    if (criterion.metric == Metric::Flip)
        document["pixelsPerDegree"] = criterion.pixelsPerDegree;
    if (comparison.sameSize())
        addNumbers(document, comparison);
    return documentText(Json::array({std::move(document)}));
}

int report(const CompareOptions& options, const std::optional<ImageOutput>& output, Comparison comparison,
           const std::string& note) {
    if (output && comparison.sameSize())
        if (const auto written = output->write(textureOf(std::move(comparison.map), output->format->name));
            !written)
            return complain(written.error(), picturesUnknown);
    if (output && !comparison.sameSize())
        comparison.sentence = Sentence(furtherKey, comparison.sentence,
                                       Sentence(N_("so there is no picture of the difference")));
    if (!isStandardOutput(options.out)) {
        const Result<void> printed =
            print(options.json ? comparisonJson(options, comparison, note)
                               : comparison.sentence.english() + (note.empty() ? "" : "; " + note) + "\n");
        if (!printed)
            return complain(printed.error(), picturesUnknown);
    }
    return comparison.alike ? picturesAreAlike : picturesDiffer;
}

struct Pictures {
    Image expected;
    Image actual;
    Image mask;            ///< empty where none is named
    int componentBits = 8; ///< the most that one of the two files has
};

Result<Pictures> readPictures(const CompareOptions& options) {
    Pictures pictures;
    for (const auto& [path, to] :
         {std::pair(&options.expected, &pictures.expected), std::pair(&options.actual, &pictures.actual),
          std::pair(&options.criterion.mask, &pictures.mask)}) {
        if (path == &options.criterion.mask && path->empty())
            continue;
        Result<ReadPicture> picture = readPicture(*path);
        if (!picture)
            return fail(picture.error());
        *to = std::move(picture->image);
        if (path != &options.criterion.mask)
            pictures.componentBits = std::max(pictures.componentBits, picture->componentBits);
    }
    return pictures;
}

/// Both by their names, or both without.
Result<CompareOptions> named(CompareOptions options) {
    const bool isNamed = !options.expected.empty() || !options.actual.empty();
    if (isNamed ? !options.pictures.empty() || options.expected.empty() || options.actual.empty()
                : options.pictures.size() != 2)
        return fail(ErrorCode::OutOfRange,
                    "expected two pictures: EXPECTED ACTUAL, or --expected FILE --actual FILE");
    if (!isNamed) {
        options.expected = options.pictures[0];
        options.actual = options.pictures[1];
    }
    return options;
}

int comparePictureFiles(const CompareOptions& given) {
    const Result<CompareOptions> both = named(given);
    if (!both)
        return complain(both.error(), wrongCall);
    const CompareOptions& options = *both;
    const Result<Criterion> criterion = parseCriterion(options.criterion);
    if (!criterion)
        return complain(criterion.error(), wrongCall);
    if (options.json && isStandardOutput(options.out))
        return complain(standardOutputIsTaken("--json").value(), wrongCall);
    const std::vector<std::string> inputs{options.expected, options.actual, options.criterion.mask};
    if (const Result<void> once = checkStandardInputOnce(inputs); !once)
        return complain(once.error(), wrongCall);
    if (const Result<void> other = checkOutputsApart(std::array{NamedOutput{"--out", options.out}}, inputs);
        !other)
        return complain(other.error(), wrongCall);
    std::optional<ImageOutput> output;
    if (!options.out.empty()) {
        auto opened = openImageOutput(options.out, "PNG");
        if (!opened)
            return picturesUnknown;
        output = *std::move(opened);
    }

    const Result<Pictures> pictures = readPictures(options);
    if (!pictures)
        return complain(pictures.error(), picturesUnknown);
    LongWork progress("texshot: comparing");
    ComparisonWork work;
    work.map = output.has_value();
    work.stop = progress.stopToken();
    work.report = [&progress](float done) { progress.report(done); };
    Result<Comparison> comparison =
        comparePictures(pictures->expected, pictures->actual, *criterion,
                        options.criterion.mask.empty() ? nullptr : &pictures->mask, work);
    progress.finish();
    if (progress.stopToken().stop_requested())
        return complainInterrupted();
    if (!comparison)
        return complain(comparison.error(), picturesUnknown);
    return report(options, output, *std::move(comparison), depthNote(pictures->componentBits));
}

std::string citations() {
    std::string text;
    for (const MetricRow& each : metricRows)
        if (!each.citation.empty())
            text += fmt::format("{}: {}.\n", rowOf(each.metric).name, each.citation);
    return text;
}

} // namespace

void addCompare(CommandLine& line) {
    Command& command = line.command("compare", "Compare two pictures and find where they differ.");
    auto options = std::make_shared<CompareOptions>();
    command.usage({"EXPECTED ACTUAL", "--expected FILE --actual FILE"});
    command.option(
        "FILE", options->pictures,
        "The expected picture, then the actual one, in any format that Texplorer reads; - for standard "
        "input.");
    command.option("--expected", options->expected, "The expected picture.", {.value = "FILE"});
    command.option("--actual", options->actual, "The actual picture.", {.value = "FILE"});
    addCriterionArgument(command, options->criterion);
    command.option(
        "-o,--out", options->out,
        fmt::format("Write the difference as a picture, with the format of its extension: {}; - for "
                    "standard output, as PNG. Black is equal, dark blue is within the tolerance, violet, "
                    "red to pale yellow is above it, grey is masked.",
                    writtenExtensions(" or ")),
        {.value = "FILE"});
    command.flag("--json", options->json, "As JSON, for programs.");
    command.footer(
        "Components are compared as numbers from 0 to 255. Components of more bits are rounded to 8, which "
        "the output mentions. Positions are counted from the upper left.\n"
        "ssim: for red, green, blue (and alpha, unless both are opaque) with the paper's Gaussian window; "
        "the edge repeats outside. flip: pictures that aren't opaque are compared over black and over "
        "white.\n" +
        citations() +
        "Exit status: 0 they are alike, 1 they differ, 2 one of them can't be read, or invalid arguments.");
    command.onCall([options] { return comparePictureFiles(*options); });
}

} // namespace texplorer::screenshot
