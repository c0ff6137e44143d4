#include "app/ui/language/translate.h"

#include <string>
#include <unordered_map>
#include <utility>

namespace texplorer::ui {
namespace {

struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

// Global, like Dear ImGui's own context, for the window that is being drawn.
const Catalogue* inUse = nullptr;
std::set<std::string, std::less<>>* gapsFound = nullptr;
std::unordered_map<std::string, std::string, TextHash, std::equal_to<>> labelled; // same from frame to frame

constexpr std::size_t maxLabels = 20'000;

void noteGap(std::string_view english) {
    if (gapsFound)
        gapsFound->emplace(english);
}

const std::string* found(std::string_view english) {
    const std::string* text = inUse && !english.empty() ? inUse->find(english) : nullptr;
    if (inUse && !text)
        noteGap(english);
    return text;
}

const std::string& rememberedLabel(std::string_view english) {
    const auto known = labelled.find(english);
    if (known != labelled.end())
        return known->second;
    const std::size_t end = english.find("##");
    const std::string_view shown = english.substr(0, end);
    const std::string text = tr(shown);
    std::string whole = text == shown ? std::string(english)
                        : english.find("###") != std::string_view::npos
                            ? text + std::string(english.substr(end))
                            : text + "###" + std::string(english);
    return labelled.emplace(english, std::move(whole)).first->second;
}

} // namespace

void useCatalogue(const Catalogue* catalogue, std::set<std::string, std::less<>>* gaps) {
    if (catalogue != inUse || gaps != gapsFound)
        labelled.clear();
    inUse = catalogue;
    gapsFound = gaps;
}

const Catalogue* catalogueInUse() {
    return inUse;
}

const char* tr(const char* english) {
    const std::string* text = found(english);
    return text ? text->c_str() : english;
}

std::string tr(std::string_view english) {
    const std::string* text = found(english);
    return text ? *text : std::string(english);
}

std::string tr(const Sentence& english) {
    if (!inUse || english.isName())
        return english;
    return english.key().empty() ? tr(std::string_view(english)) : inUse->translate(english, noteGap);
}

std::string grouped(std::size_t number) {
    constexpr std::size_t group = 3;
    const std::string_view separator = rowOf(inUse ? inUse->language() : Language::English).thousands;
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > group;) {
        at -= group;
        text.insert(at, separator);
    }
    return text;
}

Sentence bytesText(std::size_t bytes) {
    return Sentence::ofParts(Sentence::plural("{0} byte", "{0} bytes", bytes).key(),
                             {Sentence::ofNumber(grouped(bytes), bytes)});
}

const char* label(const char* english) {
    return inUse && *english ? rememberedLabel(english).c_str() : english;
}

std::string label(std::string_view english) {
    return inUse && !english.empty() ? rememberedLabel(english) : std::string(english);
}

std::string label(const Sentence& english) {
    if (!inUse || (english.key().empty() && !english.isName()))
        return label(std::string_view(english)); // may have a part after "##"
    const std::string text = tr(english);
    return text == english.english() ? text : text + "###" + english.english();
}

void beginTranslations() {
    if (labelled.size() > maxLabels)
        labelled.clear();
}

} // namespace texplorer::ui
