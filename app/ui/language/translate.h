#pragma once

#include "app/ui/language/catalogue.h"

#include <set>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Sets the catalogue for the window's texts; nullptr: English. It must outlive its use. `gaps` collects
/// texts without a translation, for tests.
void useCatalogue(const Catalogue* catalogue, std::set<std::string, std::less<>>* gaps = nullptr);

[[nodiscard]] const Catalogue* catalogueInUse();

/// Translates an English text to the window's language. Our own functions that take texts translate them;
/// Dear ImGui's functions get the result of this one. The returned pointer of the first overload is valid as
/// long as the argument and the catalogue. A text is translated as a whole; one with inserted values is a
/// Sentence.
[[nodiscard]] const char* tr(const char* english);
[[nodiscard]] std::string tr(std::string_view english);
[[nodiscard]] inline std::string tr(const std::string& english) {
    return tr(std::string_view(english));
}
[[nodiscard]] std::string tr(const Sentence& english);

/// A number with its thousands separated as in the window's language: "1,398,100".
[[nodiscard]] std::string grouped(std::size_t number);
/// "1,398,100 bytes"
[[nodiscard]] Sentence bytesText(std::size_t bytes);

/// The same for texts from which Dear ImGui makes an ID: of a button, a menu, a tab, a dialog. The ID stays
/// the English one, with the part after "##".
[[nodiscard]] const char* label(const char* english);
[[nodiscard]] std::string label(std::string_view english);
[[nodiscard]] inline std::string label(const std::string& english) {
    return label(std::string_view(english));
}
[[nodiscard]] std::string label(const Sentence& english);

/// Begins a frame: cached labels may be freed.
void beginTranslations();

} // namespace texplorer::ui
