#include "app/ui/files/sheet_file.h"

#include "app/lettering/font_lettering.h"
#include "app/ui/model/session.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/state/sheet_choice.h"
#include "app/view/picture_texts.h"
#include "texplorer/base/sentence.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/sheet/sheet_picture.h"
#include "texplorer/text/printable.h"

#include <memory>
#include <string_view>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr std::string_view referenceName = rowOf(RendererKind::Reference).name;

std::vector<PictureText> textsOfSheet(const SheetOrder& order) {
    view::PictureFacts facts{order.picture.scene,
                             order.picture.time,
                             {order.picture.width, order.picture.height},
                             std::string(referenceName)};
    for (const SweepAxis* axis : {&order.rows, &order.columns})
        facts.axes.push_back(view::axisText(*axis, axis->values));
    facts.program = "texplorer";
    return view::textsOf(facts);
}

/// The layout of a sheet, and the writer of its words.
struct LetteredSheet {
    std::shared_ptr<const sheet::Lettering> pen;
    sheet::Layout layout;
};

Result<LetteredSheet> letteredSheet(const sheet::Content& content) {
    // Opened once: a panel asks for the sheet's extent in every frame.
    static const Result<std::shared_ptr<const sheet::Lettering>> pen = openLettering();
    if (!pen)
        return fail(pen.error());
    return sheet::layoutOf(content, **pen).map([](sheet::Layout layout) {
        return LetteredSheet{*pen, std::move(layout)};
    });
}

Result<MadeFile> madeOf(const SheetOrder& order, const LetteredSheet& on, const FileMaking& making) {
    reference::ReferenceRenderer renderer;
    sheet::SheetPicture picture(on.layout);
    const std::size_t columns = order.columns.values.size();
    const std::size_t all = on.layout.cells.size();
    std::size_t refused = 0;
    Sentence firstRefusal;
    for (std::size_t cell = 0; cell < all; ++cell) {
        making.report(static_cast<float>(cell) / static_cast<float>(all));
        reference::DrawRequest request = order.picture;
        Result<Scene> scene =
            sheetScene(order.picture.scene, order.rows, cell / columns, order.columns, cell % columns);
        if (scene)
            request.scene = *std::move(scene);
        const Result<Frame> frame = scene ? renderer.draw(request, {.threads = making.threads,
                                                                    .levels = making.levels,
                                                                    .stop = making.levels.stop})
                                          : fail(scene.error());
        if (frame) {
            picture.put(cell, frame->image);
            continue;
        }
        if (frame.error().code == ErrorCode::Cancelled)
            return fail(frame.error());
        const Sentence words = describe(frame.error());
        picture.refuse(cell, printable(words));
        if (refused++ == 0)
            firstRefusal = words;
    }
    if (refused == all)
        return fail(ErrorCode::Unsupported, Sentence("none of its pictures can be drawn: {0}", firstRefusal));
    Result<Bytes> bytes =
        encodePng(std::move(picture).take(*on.pen), WriteOptions{.texts = textsOfSheet(order)});
    if (!bytes)
        return fail(bytes.error());
    MadeFile made{*std::move(bytes)};
    if (refused > 0)
        made.remark = Sentence("{0} of {1} can't be drawn. Each shows the reason.", refused,
                               Sentence::plural("{0} picture", "{0} pictures", all));
    return made;
}

} // namespace

Result<SheetOrder> sheetOrder(const Session& session) {
    Result<std::array<SweepAxis, 2>> axes = sweptAxes(session);
    if (!axes)
        return fail(axes.error());
    const SheetChoice& choice = session.sheet;
    const std::size_t rows = axes->front().values.size();
    const std::size_t columns = axes->back().values.size();
    if (rows * columns > sheet::maxPictures) // each has at most maxAxisValues
        return fail(ErrorCode::TooLarge, Sentence("expected at most {0} pictures on a sheet, found {1} × {2}",
                                                  sheet::maxPictures, rows, columns));
    const Document& document = session.document;
    std::vector<sheet::AxisLabels> labels = sheet::labelsOf(document.scene, *axes, choice.labels);
    const std::string name = nameOf(document);
    sheet::Content content{.title = name.empty() ? N_("Default scene") : printable(name)};
    content.cell = {choice.width, choice.height};
    content.down = std::move(labels[0]);
    content.across = std::move(labels[1]);
    return SheetOrder{{document.scene, document.images, session.look.playback.time, choice.width,
                       choice.height, session.view.anisotropy, session.view.rho},
                      std::move(axes->front()),
                      std::move(axes->back()),
                      std::move(content)};
}

std::string sheetFileName(const Document& document) {
    return fileNameOf(document, "-sheet.png");
}

Result<FileOrder> fileOrder(SheetOrder sheet, std::filesystem::path file) {
    return letteredSheet(sheet.content).map([&](LetteredSheet on) {
        const std::size_t pictures = on.layout.cells.size();
        return FileOrder{std::move(file), N_("The sheet can't be written: {0}."), pictures,
                         [order = std::move(sheet), lettered = std::move(on)](const FileMaking& making) {
                             return madeOf(order, lettered, making);
                         }};
    });
}

Result<glm::ivec2> sheetExtent(const Session& session) {
    return sheetOrder(session)
        .and_then([](const SheetOrder& order) { return letteredSheet(order.content); })
        .map([](const LetteredSheet& on) { return on.layout.size; });
}

Result<void> saveSheet(Session& session, const std::filesystem::path& file,
                       const std::optional<FileFingerprint>& replaces) {
    return sheetOrder(session)
        .and_then([&](SheetOrder sheet) { return fileOrder(std::move(sheet), file); })
        .and_then([&](FileOrder order) {
            return session.services.writing->writeAs(std::move(order), ".png", replaces);
        });
}

} // namespace texplorer::ui
