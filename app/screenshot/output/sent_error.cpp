#include "app/screenshot/output/sent_error.h"

#include "app/screenshot/output/message_ids.h"
#include "app/view/sent_sentence.h"

#include <string>
#include <utility>

namespace texplorer::screenshot {
namespace {

using nlohmann::json;

/// One of an enumeration's values, the first of which is 0.
template<class Enum>
Enum sentValue(const json& sent, Enum last) {
    const auto number = sent.get<unsigned>();
    if (number > static_cast<unsigned>(last))
        throw json::out_of_range::create(401, "no such value", &sent);
    return static_cast<Enum>(number);
}

} // namespace

json sentJson(const Error& error) {
    json steps = json::array();
    for (const Location::Step& each : error.where.steps())
        steps.push_back({static_cast<int>(each.kind), each.text, each.line, each.column});
    return {{"code", static_cast<int>(error.code)},
            {"message", view::sentJson(error.message)},
            {"where", std::move(steps)}};
}

Error sentError(const json& sent) {
    Error error{sentValue(sent.at("code"), ErrorCode::Cancelled),
                view::sentSentence(sent.at("message"), knownMessage),
                {}};
    for (const json& each : sent.at("where"))
        error.where = error.where /
                      Location(Location::Step{sentValue(each.at(0), Location::Kind::Name),
                                              each.at(1).get<std::string>(), each.at(2).get<std::size_t>(),
                                              each.at(3).get<std::size_t>()});
    return error;
}

} // namespace texplorer::screenshot
