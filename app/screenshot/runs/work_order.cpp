#include "app/screenshot/runs/work_order.h"

#include "app/screenshot/output/message_ids.h"
#include "app/screenshot/output/sent_error.h"
#include "texplorer/suite/record_json.h"

#include <nlohmann/json.hpp>

namespace texplorer::screenshot {
namespace {

using OrderJson = nlohmann::json;

/// MessagePack: its strings are bytes.
std::string packed(const OrderJson& json) {
    std::string bytes;
    OrderJson::to_msgpack(json, bytes);
    return bytes;
}

Result<OrderJson> unpacked(std::string_view bytes) {
    OrderJson json = OrderJson::from_msgpack(bytes, true, false);
    if (json.is_discarded())
        return fail(ErrorCode::Malformed, "expected a message of texshot, found other bytes");
    return json;
}

OrderJson jsonOf(const RunSetup& setup) {
    std::vector<std::uint32_t> renderers;
    for (const RendererKind each : setup.renderers)
        renderers.push_back(static_cast<std::uint32_t>(each));
    const Criterion& criterion = setup.criterion;
    return {{"suites", setup.suites},
            {"renderers", renderers},
            {"only", setup.only},
            {"plan", setup.plan},
            {"drawing", setup.drawing},
            {"report", setup.report},
            {"shaders", setup.shaders},
            {"pretended", setup.pretended},
            {"context", setup.context},
            {"threads", setup.threads},
            {"actual", setup.actual},
            {"golden", setup.golden},
            {"mask", setup.mask},
            {"metric", static_cast<std::uint32_t>(criterion.metric)},
            {"tolerance", criterion.tolerance},
            {"share", criterion.share},
            {"compared", static_cast<std::uint32_t>(criterion.compared)},
            {"pixelsPerDegree", criterion.pixelsPerDegree}};
}

RunSetup setupOf(const OrderJson& json) {
    RunSetup setup;
    json.at("suites").get_to(setup.suites);
    for (const std::uint32_t each : json.at("renderers").get<std::vector<std::uint32_t>>())
        setup.renderers.push_back(static_cast<RendererKind>(each));
    json.at("only").get_to(setup.only);
    json.at("plan").get_to(setup.plan);
    json.at("drawing").get_to(setup.drawing);
    json.at("report").get_to(setup.report);
    json.at("shaders").get_to(setup.shaders);
    json.at("pretended").get_to(setup.pretended);
    json.at("context").get_to(setup.context);
    json.at("threads").get_to(setup.threads);
    json.at("actual").get_to(setup.actual);
    json.at("golden").get_to(setup.golden);
    json.at("mask").get_to(setup.mask);
    setup.criterion.metric = static_cast<Metric>(json.at("metric").get<std::uint32_t>());
    json.at("tolerance").get_to(setup.criterion.tolerance);
    json.at("share").get_to(setup.criterion.share);
    setup.criterion.compared = static_cast<Compared>(json.at("compared").get<std::uint32_t>());
    json.at("pixelsPerDegree").get_to(setup.criterion.pixelsPerDegree);
    return setup;
}

/// Refuses what lacks a member, or has one of another type.
template<class Value, class Read>
Result<Value> readBy(std::string_view bytes, const Read& read) {
    const Result<OrderJson> json = unpacked(bytes);
    if (!json)
        return fail(json.error());
    try {
        return read(*json);
    } catch (const OrderJson::exception&) {
        return fail(ErrorCode::Malformed, "expected an order of this version of texshot, found another");
    }
}

} // namespace

std::string bytesOf(const WorkOrder& order) {
    return packed({{"setup", jsonOf(order.setup)},
                   {"what", static_cast<std::uint32_t>(order.what)},
                   {"number", order.number},
                   {"name", order.name},
                   {"hasActual", order.hasActual},
                   {"hasGolden", order.hasGolden},
                   {"update", order.update}});
}

Result<WorkOrder> parseOrder(std::string_view bytes) {
    return readBy<WorkOrder>(bytes, [](const OrderJson& json) {
        WorkOrder order;
        order.setup = setupOf(json.at("setup"));
        order.what = static_cast<WorkOrder::What>(json.at("what").get<std::uint32_t>());
        json.at("number").get_to(order.number);
        json.at("name").get_to(order.name);
        json.at("hasActual").get_to(order.hasActual);
        json.at("hasGolden").get_to(order.hasGolden);
        json.at("update").get_to(order.update);
        return order;
    });
}

std::string bytesOf(const WorkAnswer& answer) {
    std::string line;
    if (std::optional<suite::CaseRecord> record = answer.record) {
        record->id = firstIdOf(record->sentence); // of which the line has the words alone
        line = suite::journalLine(*record);
    }
    return packed({{"record", line},
                   {"name", answer.record ? answer.record->name : std::string()},
                   {"wrote", answer.wrote},
                   {"problem", answer.problem ? sentJson(*answer.problem) : OrderJson()},
                   {"driver", answer.driver},
                   {"version", answer.version}});
}

Result<WorkAnswer> parseAnswer(std::string_view bytes) {
    std::string record;
    std::string name;
    Result<WorkAnswer> answer = readBy<WorkAnswer>(bytes, [&record, &name](const OrderJson& json) {
        WorkAnswer found;
        json.at("record").get_to(record);
        json.at("name").get_to(name);
        json.at("wrote").get_to(found.wrote);
        if (const OrderJson& problem = json.at("problem"); !problem.is_null())
            found.problem = sentError(problem);
        json.at("driver").get_to(found.driver);
        json.at("version").get_to(found.version);
        return found;
    });
    if (answer && !record.empty()) {
        Result<suite::CaseRecord> parsed = suite::parseCaseRecord(record);
        if (!parsed)
            return fail(parsed.error());
        answer->record = *std::move(parsed);
        answer->record->name = name;
    }
    return answer;
}

} // namespace texplorer::screenshot
