#include "app/screenshot/runs/pair_worker.h"

#include "app/screenshot/runs/case_pictures.h"
#include "app/screenshot/runs/golden_file.h"
#include "core/base/file_io.h"
#include "core/codec/png/png.h"
#include "core/codec/registry.h"
#include "core/suite/case_name.h"
#include "core/suite/judge_case.h"
#include "core/suite/suite_folder.h"

#include <fmt/core.h>

#include <optional>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;
using suite::CaseRecord;
using suite::State;

struct PictureFile {
    Bytes bytes;
    Image image;
};

Result<PictureFile> readPictureFile(const fs::path& path) {
    Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    Result<Image> image = decodeImage(*bytes);
    if (!image)
        return fail(image.error().code, describe(image.error()), path.string());
    return PictureFile{*std::move(bytes), *std::move(image)};
}

WorkAnswer problemOf(const WorkOrder& order, const Error& error) {
    return {.record = CaseRecord{.name = order.name, .state = State::Error, .sentence = describe(error)}};
}

/// Pictures of a page have no more than 8 bits; other formats are shown as the codec shows them.
WorkAnswer answerWithPictures(const WorkOrder& order, CaseRecord record, const CasePictures& pictures) {
    if (!order.setup.report.empty()) {
        const Result<void> written =
            writePictures(order.setup.report, suite::fileNameFor(order.name), pictures, record);
        if (!written)
            return problemOf(order, written.error());
    }
    return {.record = std::move(record)};
}

} // namespace

WorkAnswer comparePair(const WorkOrder& order) {
    std::optional<PictureFile> expected;
    std::optional<PictureFile> actual;
    for (const bool isGolden : {true, false}) {
        if (!(isGolden ? order.hasGolden : order.hasActual))
            continue;
        const fs::path folder = isGolden ? order.setup.golden : order.setup.actual;
        const Result<fs::path> path = suite::pathInside(folder, order.name);
        if (!path)
            return problemOf(order, path.error());
        Result<PictureFile> read = readPictureFile(*path);
        if (!read)
            return problemOf(order, read.error());
        (isGolden ? expected : actual) = *std::move(read);
    }
    CaseRecord record{.name = order.name, .state = State::Missing, .golden = order.name};
    if (!actual) {
        record.sentence = "there is a golden, and no picture";
        return answerWithPictures(order, std::move(record), {.expected = &expected->image});
    }
    if (!expected) {
        record.state = State::Extra;
        record.golden.clear();
        record.sentence = "there is a picture, and no golden";
        if (order.update)
            return writeGolden(order.setup.golden, order.name, ByteView(actual->bytes), std::move(record));
        return answerWithPictures(order, std::move(record), {.actual = &actual->image});
    }
    std::optional<Image> mask;
    if (!order.setup.mask.empty()) {
        Result<PictureFile> read = readPictureFile(order.setup.mask);
        if (!read)
            return problemOf(order, read.error());
        mask = std::move(read->image);
    }
    const suite::JudgedCase judged =
        suite::judgePictures(order.setup.criterion, order.name, expected->image, actual->image,
                             mask ? &*mask : nullptr, order.setup.threads);
    if (judged.record.state == State::Passed)
        return {.record = judged.record};
    if (order.update && isUpdatable(judged.record))
        return writeGolden(order.setup.golden, order.name, ByteView(actual->bytes), judged.record);
    return answerWithPictures(order, judged.record,
                              {.expected = &expected->image,
                               .actual = &actual->image,
                               .difference = judged.difference ? &*judged.difference : nullptr});
}

} // namespace texplorer::screenshot
