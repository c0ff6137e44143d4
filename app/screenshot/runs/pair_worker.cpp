#include "app/screenshot/runs/pair_worker.h"

#include "app/screenshot/runs/case_pictures.h"
#include "app/screenshot/runs/golden_file.h"
#include "texplorer/suite/case_name.h"
#include "texplorer/suite/judge_case.h"
#include "texplorer/suite/stored_picture.h"
#include "texplorer/suite/suite_folder.h"

#include <optional>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;
using suite::CaseRecord;
using suite::State;
using suite::StoredPicture;

WorkAnswer problemOf(const WorkOrder& order, const Error& error) {
    return {.record = suite::problemOf({.name = order.name}, error)};
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
    std::optional<StoredPicture> expected;
    std::optional<StoredPicture> actual;
    std::optional<Error> broken; // the golden is read, and holds no picture
    for (const bool isGolden : {true, false}) {
        if (!(isGolden ? order.hasGolden : order.hasActual))
            continue;
        const fs::path folder = isGolden ? order.setup.golden : order.setup.actual;
        const Result<fs::path> path = suite::pathInside(folder, order.name);
        if (!path)
            return problemOf(order, path.error());
        Result<StoredPicture> read = suite::readStoredPicture(*path);
        if (!read && isGolden && order.update && order.hasActual && suite::isNoPicture(read.error()))
            broken = read.error();
        else if (!read)
            return problemOf(order, read.error());
        else
            (isGolden ? expected : actual) = *std::move(read);
    }
    CaseRecord record{.name = order.name, .state = State::Missing, .golden = order.name};
    if (!actual) {
        record.sentence = N_("there is a golden, and no picture");
        return answerWithPictures(order, std::move(record), {.expected = &expected->image});
    }
    if (broken) {
        record.state = State::Error;
        return writeGolden(order.setup.golden, order.name, ByteView(actual->bytes), std::move(record));
    }
    if (!expected) {
        record.state = State::Extra;
        record.golden.clear();
        record.sentence = N_("there is a picture, and no golden");
        if (order.update)
            return writeGolden(order.setup.golden, order.name, ByteView(actual->bytes), std::move(record));
        return answerWithPictures(order, std::move(record), {.actual = &actual->image});
    }
    std::optional<Image> mask;
    if (!order.setup.mask.empty()) {
        Result<StoredPicture> read = suite::readStoredPicture(order.setup.mask);
        if (!read)
            return problemOf(order, read.error());
        mask = std::move(read->image);
    }
    const suite::JudgedCase judged =
        suite::judgePictures(order.setup.criterion, order.name, expected->image, actual->image,
                             mask ? &*mask : nullptr, order.setup.threads);
    if (judged.record.state == State::Passed)
        return {.record = judged.record};
    if (order.update && isUpdatable(judged))
        return writeGolden(order.setup.golden, order.name, ByteView(actual->bytes), judged.record);
    return answerWithPictures(order, judged.record,
                              {.expected = &expected->image,
                               .actual = &actual->image,
                               .difference = judged.difference ? &*judged.difference : nullptr});
}

} // namespace texplorer::screenshot
