#include "app/screenshot/runs/case_worker.h"

#include "app/screenshot/gl/picture_texts.h"
#include "app/screenshot/reports/probe_report.h"
#include "app/screenshot/runs/case_pictures.h"
#include "app/screenshot/runs/golden_file.h"
#include "app/screenshot/runs/pair_worker.h"
#include "app/screenshot/runs/run_plan.h"
#include "texplorer/base/tried.h"
#include "texplorer/image/convert.h"
#include "texplorer/reference/probe.h"
#include "texplorer/suite/judge_case.h"
#include "texplorer/texture/block_cache.h"

#include <fmt/core.h>

#include <algorithm>
#include <new>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;
using suite::CaseRecord;
using suite::State;

reference::DrawRequest requestFor(const suite::Case& of, const suite::CaseScene& scene) {
    return {scene.scene, scene.images, of.time, of.size.width, of.size.height};
}

LevelWork levelWork() {
    LevelWork work;
    work.cache = BlockCache::ofUser();
    return work;
}

/// Where `texshot probe` says the same only if it is told how to filter.
std::string methodNote(const reference::DrawRequest& request) {
    const bool isTold = request.anisotropy != reference::DrawRequest().anisotropy &&
                        std::ranges::any_of(request.scene.textures,
                                            [](const Texture& texture) { return texture.maxAnisotropy > 1; });
    return isTold ? fmt::format("\n"
                                "This is the output of texshot probe with --anisotropy {}.\n",
                                texplorer::rowOf(request.anisotropy).name)
                  : std::string();
}

/// What `texshot probe` says of the worst pixel, whose alpha is as in the picture that one sees. Empty where
/// it can't be said: the pictures say enough.
std::string explanationOf(const suite::Case& of, const reference::DrawRequest& request,
                          const suite::WorstPixel& worst, const Image& actual, bool isOpaque) {
    const reference::PixelPlace place{worst.x, of.size.height - 1 - worst.y};
    Result<reference::Explanation> explanation = reference::probe(request, place, {.levels = levelWork()});
    if (!explanation)
        return {};
    std::string note = methodNote(request);
    if (isOpaque && explanation->bytes[3] != 255) {
        note += fmt::format("\n"
                            "The picture is opaque and does not show the framebuffer's alpha, {}.\n",
                            explanation->bytes[3]);
        explanation->bytes[3] = 255;
    }
    std::vector<ReadBack> readBacks;
    if (of.renderer != RendererKind::Reference) {
        reference::PixelBytes bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = std::to_integer<std::uint8_t>(actual.at(place.x, place.y)[i]);
        readBacks.push_back({of.renderer, bytes});
    }
    return asText(*explanation, readBacks) + note;
}

bool isSeenOpaque(const suite::Settings& settings) {
    return !std::holds_alternative<suite::GoldenReference>(settings.golden);
}

/// As what it is held against: the picture that one sees, as `texshot shot` writes it, or what is in the
/// framebuffer.
Image seenAs(const suite::Settings& settings, const Image& image) {
    if (!isSeenOpaque(settings))
        return image;
    Image seen = image;
    for (std::size_t i = 3; i < seen.pixels.size(); i += 4)
        seen.pixels[i] = std::byte{255};
    return seen;
}

/// The scene with its images named from the folder of the report's pictures, so that it can be opened there.
/// By a relative name: a report that is moved together with its suite stays whole, and says nothing of the
/// machine.
Scene sceneBesidePictures(const suite::CaseScene& of, const fs::path& report) {
    std::error_code ignored; // where the current folder was removed, a relative name stays one
    const fs::path base = fs::current_path(ignored);
    const fs::path here = (base / of.images.directory()).lexically_normal() / "";
    const fs::path there = (base / report / picturesFolder).lexically_normal() / "";
    Scene scene = of.scene;
    renameFiles(scene, [&](const std::string& file) {
        if (of.images.fileInMemory(file) || fs::path(file).is_absolute())
            return file;
        return (here / file).lexically_normal().lexically_relative(there).generic_string();
    });
    return scene;
}

/// What a record has room for, up to the end of a line. The command says all of it.
std::string fitted(std::string text) {
    constexpr std::size_t maxReportBytes = std::size_t{64} << 10;
    if (text.size() <= maxReportBytes)
        return text;
    const std::size_t end = text.rfind('\n', maxReportBytes - 1);
    text.resize(end == std::string::npos ? maxReportBytes : end + 1);
    return text + fmt::format("\n"
                              "This is cut after {} bytes; texshot probe prints all of it.\n",
                              maxReportBytes);
}

} // namespace

std::string CaseWorker::work(const std::string& bytes) {
    const Result<WorkOrder> order = parseOrder(bytes);
    if (!order)
        return bytesOf(WorkAnswer{.problem = order.error()});
    const Result<WorkAnswer> done =
        tried({"not enough memory for it", "it failed"}, [&] { return follow(*order); });
    if (done)
        return bytesOf(*done);
    loaded_.reset();
    images_ = ImageSource();
    WorkAnswer answer{.problem = done.error()};
    if (order->what == WorkOrder::What::Case && plan_ && order->number < plan_->cases.size())
        answer.record =
            problemOf(recordOf(*plan_, plan_->cases[order->number], State::Error, {}), done.error());
    if (order->what == WorkOrder::What::Pictures)
        answer.record = problemOf(CaseRecord{.name = order->name}, done.error());
    return bytesOf(answer);
}

WorkAnswer CaseWorker::follow(const WorkOrder& order) {
    switch (order.what) {
    case WorkOrder::What::Driver:
        return openDriver(order);
    case WorkOrder::What::Case:
        return doCase(order);
    case WorkOrder::What::Pictures:
        return comparePair(order);
    }
    return {.problem = Error{ErrorCode::Malformed, N_("unknown order"), {}}};
}

Result<Studio*> CaseWorker::studio(const RunSetup& setup) {
    if (!studio_) {
        const Result<view::Pretence> pretence = view::Pretence::parse(setup.pretended);
        if (!pretence)
            return fail(pretence.error());
        const Result<view::ContextChoice> context = view::ContextChoice::parse(setup.context, "--context");
        if (!context)
            return fail(context.error());
        Result<std::unique_ptr<Studio>> opened = openStudio(setup.shaders, *pretence, *context);
        if (!opened)
            return fail(opened.error());
        studio_ = *std::move(opened);
    }
    return studio_.get();
}

WorkAnswer CaseWorker::openDriver(const WorkOrder& order) {
    const Result<Studio*> opened = studio(order.setup);
    if (!opened)
        return {.problem = opened.error()};
    const conform::Driver driver = (*opened)->driver();
    return {.driver = driver.name, .version = driver.version};
}

Result<void> CaseWorker::plan(const RunSetup& setup) {
    if (plan_ && setup == planned_)
        return {};
    plan_.reset();
    Result<suite::Plan> plan = readPlan(setup);
    if (!plan)
        return fail(plan.error());
    if (fingerprintOf(*plan) != setup.plan)
        return fail(ErrorCode::Malformed, "the cases of the suite have changed since the run began");
    plan_ = *std::move(plan);
    planned_ = setup;
    fingerprints_ = std::make_unique<suite::Fingerprints>();
    loaded_.reset();
    return {};
}

/// With its images, of which those of the last case are there.
Result<suite::CaseScene> CaseWorker::openScene(const suite::Case& of) {
    Result<suite::CaseScene> scene = suite::openScene(*plan_, of);
    if (!scene)
        return scene;
    const ScenePlace place{of.suite, of.entry, of.scene};
    Result<void> loaded = fail(ErrorCode::NotFound, "nothing is");
    if (loaded_ == place) {
        ImageSource own = std::exchange(scene->images, images_);
        loaded = scene->load();
        if (!loaded) // together they may be too large
            scene->images = std::move(own);
    }
    if (!loaded)
        loaded = scene->load();
    if (!loaded)
        return fail(loaded.error());
    loaded_ = place;
    images_ = scene->images;
    return scene;
}

Result<Frame> CaseWorker::draw(const RunSetup& setup, const suite::Case& of, const suite::CaseScene& scene) {
    if (of.renderer == RendererKind::Reference)
        return reference::drawReference(requestFor(of, scene),
                                        {.threads = setup.threads, .levels = levelWork()});
    const Result<Studio*> opened = studio(setup);
    if (!opened)
        return fail(opened.error());
    const view::OfferedRenderers offered = (*opened)->renderers();
    if (!offered.has(of.renderer))
        return fail(ErrorCode::Unsupported, offered.whyNot(of.renderer));
    return (*opened)->draw(of.renderer, requestFor(of, scene), levelWork());
}

WorkAnswer CaseWorker::doCase(const WorkOrder& order) {
    const Result<void> planned = plan(order.setup);
    if (!planned || order.number >= plan_->cases.size())
        return {.problem = planned ? Error{ErrorCode::OutOfRange, N_("there is no such case"), {}}
                                   : planned.error()};
    const suite::Case& of = plan_->cases[order.number];
    const CaseRecord bare = recordOf(*plan_, of, State::Error, {});

    conform::Driver driver;
    WorkAnswer answer;
    if (of.renderer != RendererKind::Reference) {
        const Result<Studio*> opened = studio(order.setup);
        if (!opened)
            return {.record = problemOf(bare, opened.error())};
        driver = (*opened)->driver();
    }
    answer.record = recordWithoutDrawing(*plan_, of);
    if (!answer.record) {
        const Result<suite::CaseScene> scene = openScene(of);
        if (!scene) {
            answer.record = problemOf(bare, scene.error());
        } else if (answer.record = recordWithoutDrawing(*plan_, of, *scene, driver); !answer.record) {
            Result<Frame> frame = draw(order.setup, of, *scene);
            if (frame)
                answer = judge(order, of, std::move(*frame), *scene, driver);
            else
                answer.record = problemOf(bare, frame.error());
        }
    }
    answer.record->driver = driver.name;
    answer.record->fingerprint =
        fingerprints_->of(*plan_, of, drawnWith(order.setup, driver.version), driver.name);
    return answer;
}

WorkAnswer CaseWorker::judge(const WorkOrder& order, const suite::Case& of, Frame frame,
                             const suite::CaseScene& scene, const conform::Driver& driver) {
    const suite::Settings& settings = plan_->settingsOf(of);
    const Image actual = seenAs(settings, frame.image);
    suite::JudgedCase judged = judgeCase(*plan_, of, scene, actual, driver, order.setup.threads);
    CaseRecord& record = judged.record;
    if (record.state == State::Passed || record.state == State::Skipped)
        return {.record = std::move(record)};

    for (const std::string& problem : frame.problems)
        record.explanation += problem + "\n";
    if (record.state == State::Failed && record.worst) {
        reference::DrawRequest request = requestFor(of, scene);
        request.anisotropy = suite::anisotropyOf(settings.golden, driver);
        record.explanation += explanationOf(of, request, *record.worst, actual, isSeenOpaque(settings));
    }
    record.explanation = fitted(std::move(record.explanation));
    if (order.update && isUpdatable(judged)) {
        // The nearest of several, which it was held against; of none that is there, the first.
        if (const std::string golden = record.golden; !golden.empty())
            return writeGolden(plan_->suiteOf(of).folder, golden, actual, std::move(record));
    }
    if (!order.setup.report.empty()) {
        const bool drawn = of.renderer != RendererKind::Reference;
        const PictureFacts facts{sceneBesidePictures(scene, order.setup.report),
                                 of.time,
                                 {of.size.width, of.size.height},
                                 std::string(texplorer::rowOf(of.renderer).name),
                                 driver,
                                 drawn && studio_ ? studio_->context() : std::string()};
        const CasePictures pictures{judged.expected ? &*judged.expected : nullptr, &actual,
                                    judged.difference ? &*judged.difference : nullptr, textsOf(facts)};
        if (const Result<void> written = writePictures(order.setup.report, of.file, pictures, record);
            !written)
            return {.record = problemOf(std::move(record), written.error())};
    }
    return {.record = std::move(record)};
}

std::string drawnWith(const RunSetup& setup, std::string_view driverVersion) {
    return fmt::format("texshot {}, {}, {}", TEXPLORER_VERSION, driverVersion, setup.drawing);
}

} // namespace texplorer::screenshot
