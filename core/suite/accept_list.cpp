#include "texplorer/suite/accept_list.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/json_encoding.h"
#include "texplorer/text/nearest_name.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace texplorer::suite {
namespace {

std::string_view trimmed(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = line.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

/// "there is no case …; did you mean …?"; a list of a thousand names does not help.
Sentence unknownText(std::string_view name, const std::vector<std::string>& known) {
    const std::vector<std::string_view> names(known.begin(), known.end());
    if (!isUtf8(name) || name.find("\uFFFD") != std::string_view::npos)
        return Sentence("there is no case {0}: a name that isn't UTF-8 can't be in a list; use --update",
                        ProperName{inQuotes(name)});
    const std::string_view near = nearestName(name, names);
    return near.empty() ? Sentence("there is no case {0}", ProperName{inQuotes(name)})
                        : Sentence("there is no case {0}; did you mean {1}?", ProperName{inQuotes(name)},
                                   ProperName{inQuotes(near)});
}

} // namespace

Result<std::vector<std::string>> parseAcceptList(std::string_view text,
                                                 const std::vector<std::string>& known) {
    if (text.size() > maxAcceptBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} bytes, found {1}", maxAcceptBytes, text.size()));
    if (text.starts_with(byteOrderMark)) // as some editors write it
        text.remove_prefix(byteOrderMark.size());
    const std::unordered_set<std::string_view> names(known.begin(), known.end());
    std::unordered_map<std::string, std::string_view> shown; // as the page writes what would steer a terminal
    for (const std::string& each : known)
        if (std::string written = printable(each); written != each && isUtf8(each))
            shown.emplace(std::move(written), each);
    std::unordered_set<std::string_view> taken;
    std::vector<std::string> accepted;
    for (std::size_t at = 0, number = 1; at < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view name = text.substr(at, end - at);
        at = end + 1;
        if (!names.contains(name)) { // or it is one that begins with "#", or with a space
            name = trimmed(name);
            if (name.empty() || name.starts_with('#'))
                continue;
        }
        if (const auto real = shown.find(std::string(name)); real != shown.end() && !names.contains(name))
            name = real->second;
        if (!names.contains(name))
            return fail(ErrorCode::NotFound, unknownText(name, known), atLine(number));
        if (taken.insert(name).second)
            accepted.emplace_back(name);
    }
    if (accepted.empty())
        return fail(ErrorCode::OutOfRange, "expected the name of a case on each line, found none");
    return accepted;
}

} // namespace texplorer::suite
