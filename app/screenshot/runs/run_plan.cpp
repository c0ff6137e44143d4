#include "app/screenshot/runs/run_plan.h"

#include "texplorer/files/file_io.h"
#include "texplorer/suite/accept_list.h"
#include "texplorer/suite/case_name.h"
#include "texplorer/suite/hash.h"
#include "texplorer/suite/picture_pairs.h"
#include "texplorer/suite/suite_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <set>
#include <unordered_set>

namespace texplorer::screenshot {
namespace {

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    std::array<char, 32> text{};
    if (gmtime_r(&time, &parts) == nullptr ||
        std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts) == 0)
        return {};
    return text.data();
}

/// See RunSetup. Files that can't be read are said by the renderer that needs them.
std::string drawingOf(const RunSetup& setup) {
    suite::HashedText text;
    for (const std::string& each : setup.pretended)
        text.add(each);
    std::set<std::filesystem::path> files;
    std::error_code error;
    for (const auto& each : std::filesystem::directory_iterator(setup.shaders, error)) {
        if (each.path().extension() == ".glsl")
            files.insert(each.path());
    }
    for (const std::filesystem::path& each : files) {
        const Result<Bytes> bytes = readFile(each);
        text.add(each.filename().string());
        text.add(bytes ? suite::hashOf(*bytes) : std::string());
    }
    return text.hash();
}

struct Chosen {
    std::vector<RunItem> items; ///< of this shard
    std::size_t all;            ///< of all shards
};

/// Of a list to accept: its names alone, each to be written.
Result<Chosen> chosen(std::vector<RunItem> items, const RunChoice& choice) {
    std::unordered_set<std::string> accepted;
    if (choice.accepted) {
        std::vector<std::string> names;
        for (const RunItem& each : items)
            names.push_back(each.name);
        const Result<std::vector<std::string>> found = suite::parseAcceptList(*choice.accepted, names);
        if (!found)
            return fail(within(inFile(choice.acceptedFrom), found.error()));
        accepted.insert(found->begin(), found->end());
        std::erase_if(items, [&](const RunItem& each) { return !accepted.contains(each.name); });
    }
    for (RunItem& each : items) {
        each.update = choice.update || choice.accepted;
        if (choice.seconds > 0)
            each.limit = choice.seconds;
        if (const auto past = choice.durations.find(each.name); past != choice.durations.end())
            each.expected = past->second;
    }
    std::vector<std::string> names;
    for (const RunItem& each : items)
        names.push_back(each.name);
    Chosen own{{}, names.size()};
    for (const std::size_t index : suite::casesOfShard(names, choice.shard, choice.durations))
        own.items.push_back(std::move(items[index]));
    return own;
}

/// With its items, and what is known of the run before it begins.
PlannedRun planned(RunSetup setup, suite::Plan plan, Chosen own, const RunChoice& choice) {
    PlannedRun result;
    result.setup = std::move(setup);
    result.plan = std::move(plan);
    result.items = std::move(own.items);
    suite::RunRecord& run = result.run;
    run.program = fmt::format("texshot {}", TEXPLORER_VERSION);
    run.started = now();
    run.plan = result.setup.plan;
    run.planned = own.all;
    run.shard = choice.shard;
    for (const RunItem& each : result.items)
        run.names.push_back(each.name);
    return result;
}

} // namespace

Result<suite::Plan> readPlan(const RunSetup& setup) {
    std::vector<suite::Suite> suites;
    for (const std::string& path : setup.suites) {
        Result<std::vector<suite::Suite>> found = suite::suitesAt(path);
        if (!found)
            return fail(found.error());
        std::ranges::move(*found, std::back_inserter(suites));
    }
    return suite::planOf(std::move(suites), {.renderers = setup.renderers, .only = setup.only});
}

Result<PlannedRun> planSuites(RunSetup setup, const RunChoice& choice) {
    Result<suite::Plan> plan = readPlan(setup);
    if (!plan)
        return fail(plan.error());
    std::vector<RunItem> items;
    for (std::size_t i = 0; i < plan->cases.size(); ++i) {
        const suite::Case& each = plan->cases[i];
        const suite::Settings& settings = plan->settingsOf(each);
        items.push_back({.name = each.name,
                         .number = i,
                         .precise = std::holds_alternative<suite::GoldenReference>(settings.golden),
                         .limit = settings.seconds,
                         .pixels = static_cast<std::uint64_t>(each.size.width) *
                                   static_cast<std::uint64_t>(each.size.height)});
    }
    Result<Chosen> own = chosen(std::move(items), choice);
    if (!own)
        return fail(own.error());
    setup.plan = fingerprintOf(*plan);
    setup.drawing = drawingOf(setup);
    PlannedRun result = planned(std::move(setup), *std::move(plan), *std::move(own), choice);
    result.drawsWithOpenGl = std::ranges::any_of(result.items, [&result](const RunItem& each) {
        return result.plan.cases[each.number].renderer != RendererKind::Reference;
    });
    for (const suite::Suite& each : result.plan.suites)
        result.run.suites.push_back(each.name);
    return result;
}

Result<PlannedRun> planPictures(const RunSetup& setup, const RunChoice& choice) {
    const Result<std::vector<suite::PicturePair>> pairs =
        suite::pairPictures(setup.actual, setup.golden, setup.report);
    if (!pairs)
        return fail(pairs.error());
    std::vector<RunItem> items;
    suite::Plan named;
    for (const suite::PicturePair& each : *pairs) {
        if (!setup.only.empty() && std::ranges::none_of(setup.only, [&each](const std::string& pattern) {
                return suite::isWanted(pattern, each.name);
            }))
            continue;
        named.cases.emplace_back().name = each.name;
        items.push_back({.name = each.name,
                         .hasActual = each.hasActual,
                         .hasGolden = each.hasGolden,
                         .pixels = each.pixels});
    }
    if (items.empty())
        return fail(ErrorCode::NotFound, "expected a pattern that matches a picture", atOption("--only"));
    Result<Chosen> own = chosen(std::move(items), choice);
    if (!own)
        return fail(own.error());
    PlannedRun result = planned(setup, {}, *std::move(own), choice);
    result.run.plan = fingerprintOf(named);
    result.run.suites = {setup.golden};
    return result;
}

} // namespace texplorer::screenshot
