#include "app/screenshot/output/json_text.h"

#include <mutex>
#include <optional>

namespace texplorer::screenshot {
namespace {

using Document = nlohmann::ordered_json;

struct FirstError {
    std::mutex mutex;
    std::optional<std::string> sentence; ///< guarded by it
};

FirstError& firstError() {
    static FirstError ours;
    return ours;
}

std::optional<std::string> sentence() {
    const std::scoped_lock lock(firstError().mutex);
    return firstError().sentence;
}

} // namespace

void noteError(const std::string& sentence) {
    const std::scoped_lock lock(firstError().mutex);
    if (!firstError().sentence)
        firstError().sentence = sentence;
}

std::string documentText(const Document& document) {
    Document told = Document::object();
    if (const std::optional<std::string> error = sentence())
        told["error"] = *error;
    told.update(document);
    return told.dump(2, ' ', false, Document::error_handler_t::replace) + "\n";
}

std::string errorText() {
    return sentence() ? documentText(Document::object()) : std::string();
}

} // namespace texplorer::screenshot
