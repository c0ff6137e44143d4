#include "texplorer/conform/report.h"
#include "texplorer/conform/report_words.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::conform {

namespace {

using Json = nlohmann::ordered_json;

Json asJson(const Tally& tally) {
    return {{"scenes", tally.scenes},       {"pixels", tally.pixels},
            {"over", tally.over},           {"unexplained", tally.unexplained},
            {"withinRho", tally.withinRho}, {"max", tally.max},
            {"mean", tally.mean()}};
}

Json asJson(const Rule& rule) {
    return {{"name", rule.name},
            {"bound", rule.bound},
            {"share", rule.share},
            {"explained", rule.explained},
            {"explainedOfEachScene", rule.explainedScene},
            {"farBound", rule.farBound},
            {"nearOfEachScene", rule.nearScene},
            {"reason", rule.reason}};
}

Json asJson(const PairReport& pair, const Outcome& outcome) {
    Json json{{"feature", outcome.feature->name},
              {"sweeps", outcome.feature->sweeps},
              {"section", outcome.feature->section},
              {"agrees", outcome.verdict() != Verdict::Differ},
              {"verdict", rowOf(outcome.verdict()).name},
              {"rule", asJson(*outcome.rule)},
              {"all", asJson(outcome.all)},
              {"worstShareOfAScene", outcome.worstScene}};
    Json shapes = Json::object();
    for (const auto& [shape, tally] : outcome.shapes)
        shapes[std::string(rowOf(shape).name)] = asJson(tally);
    json["shapes"] = std::move(shapes);
    Json skipped = Json::array();
    for (const auto& [skip, count] : outcome.skipped)
        skipped.push_back({{"name", skip->name}, {"scenes", count}, {"reason", skip->reason}});
    json["skipped"] = std::move(skipped);
    Json rho = Json::object();
    for (const auto& [method, count] : outcome.rho)
        rho[std::string(rowOf(method).name)] = count;
    json["rho"] = std::move(rho);
    // What so many scenes may have.
    json["limits"] = {{"over", outcome.all.limitOver(*outcome.rule)},
                      {"unexplained", outcome.all.limitUnexplained(*outcome.rule)}};
    if (!outcome.problem.empty())
        json["problem"] = outcome.problem;
    if (outcome.worst) {
        const Judgement& judgement = outcome.worst->judgement;
        const auto [x, y] = placeOfWorst(judgement);
        json["worst"] = {{"files", worstName(pair, outcome)},
                         {"scene", outcome.worst->number},
                         {"over", judgement.difference.over},
                         {"unexplained", judgement.unexplained},
                         {"max", judgement.difference.max},
                         {"x", x},
                         {"y", y}};
    }
    return json;
}

} // namespace

std::string worstName(const PairReport& pair, const Outcome& outcome) {
    return fmt::format("{}-{}-{}", outcome.feature->name, rowOf(pair.pair.subject).name,
                       rowOf(pair.pair.against).name);
}

std::string asJson(const Report& report) {
    Json pairs = Json::array();
    for (const PairReport& pair : report.pairs) {
        Json outcomes = Json::array();
        for (const Outcome& outcome : pair.outcomes)
            outcomes.push_back(asJson(pair, outcome));
        pairs.push_back({{"renderer", rowOf(pair.pair.subject).name},
                         {"against", rowOf(pair.pair.against).name},
                         {"agrees", pair.agrees()},
                         {"features", std::move(outcomes)}});
    }
    // No time is in it: the same sweep on the same machine gives the same bytes.
    const Json json{{"program", report.origin.program},
                    {"command", report.origin.command},
                    {"driver", report.driver.name},
                    {"version", report.driver.version},
                    {"settings", report.driver.settings},
                    {"seed", report.selection.seed},
                    {"scenes", report.scenes},
                    {"width", extent},
                    {"height", extent},
                    {"compared", report.compared()},
                    {"agrees", report.agrees()},
                    {"pairs", std::move(pairs)}};
    // A driver's name may be no UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool isReport(const std::string& json) {
    const Json document = Json::parse(json, nullptr, false);
    return document.is_object() && document.contains("program") && document.contains("seed") &&
           document.contains("pairs");
}

std::string listingJson() {
    Json json{{"features", Json::array()}, {"rules", Json::array()}, {"notCompared", Json::array()}};
    std::vector<const Rule*> used;
    for (const Feature& feature : features()) {
        json["features"].push_back({{"name", feature.name},
                                    {"scenes", feature.scenes},
                                    {"section", feature.section},
                                    {"reference", feature.reference.name},
                                    {"shader", feature.shader.name},
                                    {"sweeps", feature.sweeps}});
        for (const Rule* rule : {&feature.reference, &feature.shader}) {
            if (std::ranges::find(used, rule) == used.end())
                used.push_back(rule);
        }
    }
    for (const Rule* rule : used)
        json["rules"].push_back(asJson(*rule));
    for (const Skip& skip : skips())
        json["notCompared"].push_back({{"name", skip.name}, {"reason", skip.reason}});
    return json.dump(2) + "\n";
}

} // namespace texplorer::conform
