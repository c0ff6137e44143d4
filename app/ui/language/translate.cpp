#include "app/ui/language/translate.h"

#include <unordered_map>
#include <utility>

namespace texplorer::ui {
namespace {

struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

using Memory = std::unordered_map<std::string, std::string, TextHash, std::equal_to<>>;

// Global, like Dear ImGui's own context, for the window that is being drawn.
const Catalogue* inUse = nullptr;
std::set<std::string, std::less<>>* gapsFound = nullptr;
Names namesInUse;
Memory translated; // most texts stay as they are from frame to frame
Memory labelled;

constexpr std::size_t maxRemembered = 20'000;

void forget() {
    translated.clear();
    labelled.clear();
}

enum class Gap : bool { Ignored, Recorded };

const std::string& remembered(std::string_view english, Gap gap = Gap::Recorded) {
    const auto found = translated.find(english);
    if (found != translated.end())
        return found->second;
    std::optional<std::string> text = inUse->translate(english, namesInUse);
    if (!text && gapsFound && gap == Gap::Recorded)
        gapsFound->emplace(english);
    return translated.emplace(english, text ? *std::move(text) : std::string(english)).first->second;
}

const std::string& rememberedLabel(std::string_view english) {
    const auto found = labelled.find(english);
    if (found != labelled.end())
        return found->second;
    const std::size_t end = english.find("##");
    const std::string_view shown = english.substr(0, end);
    const std::string text = shown.empty() ? std::string() : remembered(shown);
    std::string whole = text == shown ? std::string(english)
                        : english.find("###") != std::string_view::npos
                            ? text + std::string(english.substr(end))
                            : text + "###" + std::string(english);
    return labelled.emplace(english, std::move(whole)).first->second;
}

} // namespace

void useCatalogue(const Catalogue* catalogue, std::set<std::string, std::less<>>* gaps) {
    if (catalogue != inUse || gaps != gapsFound)
        forget();
    inUse = catalogue;
    gapsFound = gaps;
}

const Catalogue* catalogueInUse() {
    return inUse;
}

const char* tr(const char* english) {
    return inUse && *english ? remembered(english).c_str() : english;
}

std::string tr(std::string_view english) {
    return inUse && !english.empty() ? remembered(english) : std::string(english);
}

std::string tr(const Sentence& english) {
    if (!inUse)
        return english;
    if (english.key().empty())
        return tr(std::string_view(english));
    const auto word = [](std::string_view text) { return remembered(text, Gap::Ignored); }; // may be a name
    return inUse->translate(english, word, [](std::string_view text) {
        if (gapsFound)
            gapsFound->emplace(text);
    });
}

const char* label(const char* english) {
    return inUse && *english ? rememberedLabel(english).c_str() : english;
}

std::string label(std::string_view english) {
    return inUse && !english.empty() ? rememberedLabel(english) : std::string(english);
}

void beginTranslations() {
    if (translated.size() > maxRemembered || labelled.size() > maxRemembered)
        forget();
}

void keepNames(Names names) {
    if (names == namesInUse)
        return;
    namesInUse = std::move(names);
    forget();
}

} // namespace texplorer::ui
