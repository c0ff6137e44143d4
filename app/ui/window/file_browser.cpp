
#include "app/ui/window/file_browser.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/dialog_parts.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxListedEntries = 20000; // a larger folder is listed in part, with a note

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool hasExtension(const FileBrowser& browser, const fs::path& file) {
    const std::string extension = lowered(file.extension().string());
    return std::ranges::find(browser.extensions, extension) != browser.extensions.end();
}

bool matches(const FileBrowser& browser, const FileBrowser::Entry& entry) {
    if (entry.isFolder || browser.showAll || browser.extensions.empty())
        return true;
    return !entry.isOther && hasExtension(browser, entry.name);
}

std::string sizeText(std::uintmax_t bytes) {
    if (bytes < 1024)
        return fmt::format("{} B", bytes);
    if (bytes < std::uintmax_t{1024} * 1024)
        return fmt::format("{} KiB", (bytes + 512) / 1024);
    return fmt::format("{} MiB", (bytes + (1U << 19)) >> 20);
}

fs::path typedPath(const FileBrowser& browser) {
    std::string typed = browser.typed;
    if (typed == "~" || typed.starts_with("~/")) {
        if (const char* home = std::getenv("HOME"))
            typed.replace(0, 1, home);
    }
    return (browser.folder / typed).lexically_normal();
}

/// The action of Enter, the button and a double click: open a folder, or choose a file.
Browsing choose(FileBrowser& browser, fs::path& chosen) {
    if (browser.typed.empty()) {
        browser.error =
            browser.saving ? N_("Type a name for the file.") : N_("Choose a file, or type its path.");
        return Browsing::Open;
    }
    fs::path path = typedPath(browser);
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::is_directory(status)) {
        enterFolder(browser, path);
        if (browser.error.empty())
            browser.typed.clear();
        return Browsing::Open;
    }
    if (browser.saving) {
        if (!path.has_extension() && !browser.extensions.empty())
            path += browser.suffix.empty() ? browser.extensions.front() : browser.suffix;
        if (!fs::is_directory(path.parent_path(), failed)) {
            browser.error = Sentence("There is no folder {0}.", ProperName{path.parent_path().string()});
            return Browsing::Open;
        }
        const std::optional<FileFingerprint> there = fingerprintOf(path);
        if (there && there != browser.overwrites) {
            browser.overwrites = there;
            browser.error =
                Sentence("{0} exists. Press Overwrite to replace it.", ProperName{path.filename().string()});
            return Browsing::Open;
        }
    } else if (!fs::exists(status)) {
        browser.error = Sentence("There is no file {0}.", ProperName{path.string()});
        return Browsing::Open;
    }
    chosen = std::move(path);
    return Browsing::Chosen;
}

void mark(FileBrowser& browser, int index) {
    browser.marked = index;
    browser.overwrites.reset();
    browser.error = {};
    const FileBrowser::Entry& entry = browser.entries[static_cast<std::size_t>(index)];
    if (!entry.isFolder || !browser.saving)
        browser.typed = entry.name;
}

/// The next visible entry, upwards or downwards.
void moveMark(FileBrowser& browser, int step) {
    const int count = static_cast<int>(browser.entries.size());
    for (int i = browser.marked + step; i >= 0 && i < count; i += step) {
        if (matches(browser, browser.entries[static_cast<std::size_t>(i)])) {
            mark(browser, i);
            browser.scrollToMarked = true;
            return;
        }
    }
}

/// The parent folders, one button each.
void breadcrumbs(FileBrowser& browser) {
    fs::path target;
    fs::path walked;
    std::vector<fs::path> parts(browser.folder.begin(), browser.folder.end());
    float width = 0;
    std::size_t first = parts.size(); // the beginning of a long path is left out
    const float available = ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 4;
    while (first > 0) {
        width += ImGui::CalcTextSize(printable(parts[first - 1].string()).c_str()).x + ImGui::GetFontSize();
        if (width > available && first < parts.size())
            break;
        --first;
    }
    const bool atRoot = browser.folder == browser.folder.root_path();
    ImGui::BeginDisabled(atRoot);
    if (ImGui::Button("↑"))
        target = browser.folder.parent_path();
    ImGui::EndDisabled();
    item("browser:up", "One folder up");
    for (std::size_t i = 0; i < parts.size(); ++i) {
        walked /= parts[i];
        if (i < first)
            continue;
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x / 2);
        ImGui::PushID(static_cast<int>(i));
        if (flatButton(printable(parts[i].string()).c_str()))
            target = walked;
        ImGui::PopID();
    }
    if (!target.empty())
        enterFolder(browser, target);
}

/// The file's small picture in a square on the left of its line, once it is ready.
void drawThumbnail(const Session& session, const FileBrowser& browser, const FileBrowser::Entry& entry,
                   const Pictures& pictures, ImVec2 corner, float extent) {
    const fs::path file = browser.folder / entry.name;
    act(session,
        [file, modified = entry.modified](Session& s) { workers(s).files->askThumbnail(file, modified); });
    const std::shared_ptr<const Image> image = workers(session).files->thumbnail(file);
    if (!image || image->empty())
        return;
    noteItem("thumbnail:" + entry.name);
    const float scale = (extent - 2) / static_cast<float>(std::max(image->width, image->height));
    drawImageIn(pictures, image, corner, {extent * 1.5F, extent}, std::min(scale, 4.0F));
}

/// Returns true if an entry was double-clicked.
bool entryList(const Session& session, FileBrowser& browser, const Pictures& pictures, float height) {
    bool chosen = false;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, color::ground);
    ImGui::BeginChild("entries", {0, height}, true);
    bool any = false;
    const float sizes = ImGui::GetContentRegionAvail().x;
    for (int i = 0; i < static_cast<int>(browser.entries.size()); ++i) {
        const FileBrowser::Entry& entry = browser.entries[static_cast<std::size_t>(i)];
        if (!matches(browser, entry))
            continue;
        any = true;
        const std::string shown = printable(entry.name) + (entry.isFolder ? "/" : "");
        ImGui::PushID(i);
        const float line = ImGui::GetTextLineHeight();
        const bool pictured = browser.thumbnails && !entry.isFolder;
        const float tall = std::max(pictured ? line * 2.6F : line, targetHeight());
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const bool pressed = ImGui::Selectable("##entry", i == browser.marked,
                                               ImGuiSelectableFlags_AllowDoubleClick, {0, tall});
        noteItem("entry:" + entry.name);
        if (i == browser.marked && browser.scrollToMarked) {
            ImGui::SetScrollHereY();
            browser.scrollToMarked = false;
        }
        if (pictured && ImGui::IsItemVisible())
            drawThumbnail(session, browser, entry, pictures, corner, tall);
        // Drawn, not laid out: the line has the height of the selectable.
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float top = corner.y + (tall - line) / 2;
        const float indent = ImGui::GetStyle().FramePadding.x + (pictured ? tall * 1.5F : 0);
        draw.AddText({corner.x + indent, top}, color::text, shown.c_str());
        if (!entry.isFolder) {
            const std::string bytes = sizeText(entry.bytes);
            draw.AddText({corner.x + sizes - ImGui::CalcTextSize(bytes.c_str()).x, top}, color::dim,
                         bytes.c_str());
        }
        ImGui::PopID();
        if (pressed) {
            mark(browser, i);
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
                browser.typed = browser.entries[static_cast<std::size_t>(i)].name;
                chosen = true;
            }
        }
    }
    if (!any) {
        const char* words = browser.saving ? N_("There are no files to replace here.")
                                           : N_("There are no files to open here.");
        dimText(words);
        noteItem(fmt::format("browser:{}", words));
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    return chosen;
}

} // namespace

void enterFolder(FileBrowser& browser, const fs::path& folder) {
    std::error_code failed;
    const fs::path target = fs::weakly_canonical(folder, failed);
    fs::directory_iterator iterator(failed ? folder : target, failed);
    if (failed) {
        browser.error =
            Sentence("The folder {0} can't be read: {1}.", ProperName{folder.string()}, failed.message());
        return;
    }
    std::vector<FileBrowser::Entry> entries;
    bool cut = false;
    for (; iterator != fs::directory_iterator(); iterator.increment(failed)) {
        if (failed)
            break;
        std::string name = iterator->path().filename().string();
        if (name.starts_with('.'))
            continue;
        if (entries.size() == maxListedEntries) {
            cut = true;
            break;
        }
        std::error_code ignored;
        const bool isFolder = iterator->is_directory(ignored);
        const std::uintmax_t bytes = isFolder ? 0 : iterator->file_size(ignored);
        const bool sized = !ignored;
        const fs::file_time_type modified = iterator->last_write_time(ignored);
        const bool isOther = !isFolder && browser.isListed && hasExtension(browser, name) &&
                             !browser.isListed(iterator->path());
        entries.push_back({std::move(name), isFolder, sized ? bytes : 0,
                           ignored ? fs::file_time_type{} : modified, isOther});
    }
    std::ranges::sort(entries, [](const auto& a, const auto& b) {
        return a.isFolder != b.isFolder ? a.isFolder : lowered(a.name) < lowered(b.name);
    });
    browser.folder = target;
    browser.entries = std::move(entries);
    browser.marked = -1;
    browser.overwrites.reset();
    browser.error = cut ? Sentence("Only the first {0} entries are listed.", maxListedEntries) : "";
}

void beginBrowsing(FileBrowser& browser, std::string title, std::vector<std::string> extensions, bool saving,
                   const fs::path& startFile, bool (*isListed)(const fs::path& file)) {
    const fs::path last = browser.folder;
    browser = {};
    browser.title = std::move(title);
    browser.extensions = std::move(extensions);
    browser.isListed = isListed;
    browser.saving = saving;
    browser.focusName = true;
    std::error_code failed;
    const fs::path here = fs::current_path(failed);
    enterFolder(browser, !startFile.empty() ? startFile.parent_path() : !last.empty() ? last : here);
    if (!browser.error.empty() && browser.folder.empty())
        enterFolder(browser, here);
    if (saving)
        browser.typed =
            startFile.empty() ? "scene" + std::string(sceneExtension) : startFile.filename().string();
}

Browsing drawFileBrowser(const Session& session, FileBrowser& browser, const Pictures& pictures,
                         fs::path& chosen) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const ImVec2 size(std::min(em * 42, display.x * 0.94F), std::min(em * 32, display.y * 0.9F));
    const std::string title = browser.title + "###browser";
    if (!beginModal(title, size))
        return Browsing::Open;

    Browsing result = Browsing::Open;
    breadcrumbs(browser);
    const float line = ImGui::GetFrameHeightWithSpacing();
    const float below = 2 * line + ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    if (entryList(session, browser, pictures, std::max(em * 3, ImGui::GetContentRegionAvail().y - below)))
        result = choose(browser, chosen);

    if (browser.error.empty())
        fittedText(browser.saving ? N_("Type a name, or choose a file to replace.")
                                  : N_("Choose a file or type its path. ↑ ↓ and Enter work too."),
                   color::dim);
    else {
        fittedText(browser.error, color::problem);
        item("browser:error", browser.error);
    }

    if (browser.focusName) {
        focusNextWidget();
        browser.focusName = false;
    }
    ImGui::SetNextItemWidth(-1);
    const std::string before = browser.typed;
    const bool entered = textField("##name", browser.typed,
                                   ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    noteItem("browser:name");
    if (browser.typed != before) {
        browser.overwrites.reset();
        browser.error = {};
    }
    const bool enterElsewhere = isKeyPressed(key::enter, false) && !ImGui::IsAnyItemActive();
    if (entered || (enterElsewhere && result == Browsing::Open)) {
        result = choose(browser, chosen);
        browser.focusName = true;
    }

    if (!browser.extensions.empty()) {
        ImGui::Checkbox(label("All files"), &browser.showAll);
        const std::string extensions = fmt::format("{}", fmt::join(browser.extensions, " "));
        item("browser:all", Sentence("Lists all files, not only {0}", ProperName{extensions}));
    }
    const char* verb = !browser.saving ? N_("Open") : browser.overwrites ? N_("Overwrite") : N_("Save");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - dialogButtonWidth(N_("Cancel")) -
                    dialogButtonWidth(verb) - ImGui::GetStyle().ItemSpacing.x);
    if (dialogButton(N_("Cancel"), "browser:cancel") || isKeyPressed(key::escape, false))
        result = Browsing::Cancelled;
    ImGui::SameLine();
    if (dialogButton(verb, "browser:ok"))
        result = choose(browser, chosen);

    if (isKeyPressed(key::down))
        moveMark(browser, 1);
    if (isKeyPressed(key::up))
        moveMark(browser, -1);
    if (result != Browsing::Open)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return result;
}

} // namespace texplorer::ui
