#pragma once

#include "app/ui/language/catalogue.h"

#include <set>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// What the window's texts are translated by from here on; nullptr: they stay English. It must outlive its
/// use. `gaps`: gets what it has no translation for, for tests.
void useCatalogue(const Catalogue* catalogue, std::set<std::string, std::less<>>* gaps = nullptr);

[[nodiscard]] const Catalogue* catalogueInUse();

/// An English text in the window's language. Functions of ours that take words translate them by themselves;
/// Dear ImGui's own are given what this returns. The first one's pointer is good until the next frame.
[[nodiscard]] const char* tr(const char* english);
[[nodiscard]] std::string tr(std::string_view english);
[[nodiscard]] inline std::string tr(const std::string& english) {
    return tr(std::string_view(english));
}

/// The same for what Dear ImGui takes an identity from: a button, a menu, a tab, a dialog. That one stays the
/// English one, with what stands after "##".
[[nodiscard]] const char* label(const char* english);
[[nodiscard]] std::string label(std::string_view english);
[[nodiscard]] inline std::string label(const std::string& english) {
    return label(std::string_view(english));
}

/// A frame begins: what was remembered may be forgotten.
void beginTranslations();

/// A file or a model that is called like a text of the window, "Texture", keeps its name in sentences from
/// here on.
void keepNames(Names names);

} // namespace texplorer::ui
