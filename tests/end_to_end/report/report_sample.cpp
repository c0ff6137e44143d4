// report_sample DIR [COUNT [WIDTH [HEIGHT]]]: writes the page of an invented run, with a case of every state
// and hostile names. For the tests that open it in a browser, and for developers of the page.

#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/image.h"
#include "texplorer/report/report_files.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace texplorer {
namespace {

using report::State;

struct Size {
    int width;
    int height;
};

void setPixel(Image& image, int x, int y, std::array<int, 4> color) {
    const auto pixel = image.at(x, image.height - 1 - y);
    for (std::size_t k = 0; k < 4; ++k)
        pixel[k] = static_cast<std::byte>(color[k]);
}

/// A disk on a ground; each case has other colours. y counts from the top.
Image pictureOf(std::size_t number, Size size, int shift) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, size.width, size.height);
    const double radius = 0.3 * std::min(size.width, size.height);
    const double turn = static_cast<double>(number) * 2.4;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double dx = x - size.width * 0.5 - shift;
            const double dy = y - size.height * 0.5;
            const bool inside = dx * dx + dy * dy < radius * radius;
            const auto wave = [&](double phase) {
                return static_cast<int>(100 + 60 * std::sin(turn + phase) + (inside ? 60 : 0));
            };
            const int checker = (x / 8 + y / 8) % 2 != 0 ? 25 : 0;
            setPixel(image, x, y, {wave(0) + checker, wave(2.1) + checker, wave(4.2) + checker, 255});
        }
    }
    return image;
}

/// Where two pictures differ, white on black.
Image differenceOf(const Image& a, const Image& b) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, a.width, a.height);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const bool alike = std::ranges::equal(a.at(x, y), b.at(x, y));
            std::ranges::fill(image.at(x, y), alike ? std::byte{0} : std::byte{255});
        }
    }
    return image;
}

Bytes pngOf(const Image& image) {
    return *encodePng(image);
}

void addPictures(report::Case& each, std::size_t number, Size size) {
    const bool failed = each.state == State::Failed || each.state == State::Differ;
    const Image expected = pictureOf(number, size, 0);
    Image actual = pictureOf(number, size, failed ? 1 : 0);
    each.size = {size.width, size.height};
    if (failed) {
        // One pixel differs more than the others, and is half transparent.
        each.worst = {size.width / 4, size.height / 5};
        setPixel(actual, (*each.worst)[0], (*each.worst)[1], {255, 1, 254, 128});
        each.message = fmt::format("{} % of the pixels are over 2; the worst by 180 at {},{}.",
                                   3 + number % 7, (*each.worst)[0], (*each.worst)[1]);
        each.distance = static_cast<double>(number % 7);
        each.facts = {{"Metric", "absolute"},
                      {"Tolerance", "2"},
                      {"Over the tolerance", fmt::format("{} %", 3 + number % 7)}};
        each.explanation =
            "fragment 12,40 of pass 0\n  unit 0: GL_LINEAR, lambda = -0.41, level 0\n    texel 3,2  0.25  (255, 0, "
            "0)\n    texel 4,2  0.75  (  0, 0, 255)\n  environment: GL_MODULATE\n";
        each.commands = {{"To repeat it", fmt::format("texshot test suite.json --only {}",
                                                      "'case-" + std::to_string(number) + "'")}};
        each.links = {{"Scene", "scene.json"}};
        each.legend = {{"0", {0, 0, 0}}, {"4", {40, 80, 200}}, {"255", {255, 255, 200}}};
        each.difference = {.label = "Where it differs", .png = pngOf(differenceOf(expected, actual))};
    }
    if (each.state == State::Resized)
        actual = pictureOf(number, {size.width * 3 / 4, size.height}, 0);
    const bool drawn = each.state != State::Crashed && each.state != State::TimedOut &&
                       each.state != State::Error && each.state != State::Missing &&
                       each.state != State::NotRun && each.state != State::Skipped;
    if (each.state != State::New && each.state != State::Extra)
        each.expected = {.label = "Expected", .png = pngOf(expected)};
    if (drawn)
        each.actual = {.label = "Actual", .png = pngOf(actual)};
    each.acceptable = drawn && each.state != State::Passed && each.state != State::Agree;
}

std::string nameOf(std::size_t number) {
    switch (number) {
    case 3: // a case that failed
        return "<script>document.title='owned'</script><img src=x onerror=\"document.title='owned'\">";
    case 8:
        return "../../\"quoted\" & 'so' on/#?%41";
    case 11:
        return "line\nof \xE2\x80\xA8 separators and \xFF";
    case 12:
        return "</script>${1+1}`\\u0041";
    default:
        return fmt::format("wrap/GL_{}/case-{}", number % 2 != 0 ? "REPEAT" : "CLAMP_TO_EDGE", number);
    }
}

report::Page pageOf(std::size_t count, Size size) {
    report::Page page;
    page.title = "Sample <of> a report";
    page.tone = report::Tone::Bad;
    page.introduction = {"Pictures of a run that never was: a disk, and the same disk a pixel further."};
    page.madeBy = "report_sample on 2026-01-02 03:04 UTC";
    page.command = "report_sample DIR";
    page.environment = {{"Renderer", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                        {"Version", "4.5 (Compatibility Profile) Mesa 22.3.6"},
                        {"Context", "egl, surfaceless"}};
    page.acceptCommand = "texshot test suite.json --accept accept.txt";
    constexpr std::size_t states = EnumTable<State>::rows.size();
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
        report::Case each;
        each.name = nameOf(i);
        each.group = i % 3 != 0 ? "wrap" : "filter";
        each.state = i < states ? static_cast<State>(i) : i % 50 == 0 ? State::Failed : State::Passed;
        each.seconds = 0.004 + static_cast<double>(i * 7919 % 1000) / 5000;
        if (each.state == State::Crashed)
            each.message = "The process ended by signal 11 (Segmentation fault).";
        if (each.state == State::Skipped)
            each.message = "The driver has no GL_EXT_texture_compression_s3tc.";
        addPictures(each, i, size);
        wrong += toneOf(each.state) == report::Tone::Bad;
        page.cases.push_back(std::move(each));
    }
    page.verdict = fmt::format("{} of {} cases are wrong", wrong, count);
    report::Table table{
        .title = "By group", .columns = {{"group"}, {"cases", true}, {"verdict"}}, .rows = {}};
    for (const char* group : {"filter", "wrap"}) {
        const auto ofGroup = std::ranges::count(page.cases, group, &report::Case::group);
        const auto first = std::ranges::find(page.cases, group, &report::Case::group) - page.cases.begin();
        table.rows.push_back(
            {{group}, {std::to_string(ofGroup)}, {"wrong", State::Failed, static_cast<std::size_t>(first)}});
    }
    table.notes = {"A case belongs to one group."};
    if (count > 0)
        page.tables.push_back(std::move(table));
    return page;
}

int run(int count, char** words) {
    if (count < 2)
        return 2;
    const auto number = [&](int i, long otherwise) {
        return count > i ? std::strtol(words[i], nullptr, 10) : otherwise;
    };
    const Size size{static_cast<int>(number(3, 64)), static_cast<int>(number(4, 48))};
    auto files = report::filesOf(pageOf(static_cast<std::size_t>(number(2, 40)), size));
    if (!files) {
        fmt::print(stderr, "report_sample: {}\n", describe(files.error()));
        return 1;
    }
    const ByteView scene = viewBytes("{}\n");
    files->push_back({"scene.json", {scene.begin(), scene.end()}});
    // Not written with fsync as a program does: there may be ten thousand files, and they are temporary.
    const std::filesystem::path folder(words[1]);
    std::filesystem::create_directories(folder);
    for (const report::File& file : *files) {
        std::ofstream out(folder / file.name, std::ios::binary);
        out.write(reinterpret_cast<const char*>(file.bytes.data()),
                  static_cast<std::streamsize>(file.bytes.size()));
        if (!out.flush()) {
            fmt::print(stderr, "report_sample: {}: not written\n", file.name);
            return 1;
        }
    }
    return 0;
}

} // namespace
} // namespace texplorer

int main(int count, char** words) {
    return texplorer::run(count, words);
}
