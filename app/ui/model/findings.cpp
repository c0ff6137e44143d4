#include "app/ui/model/findings.h"

#include "app/ui/language/translate.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/sent_vertices.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace texplorer::ui {
namespace {

/// The number in "passes[3]…", where the path has this list; else -1.
int indexIn(const std::string& path, std::string_view list) {
    const std::size_t at = path.find(std::string(list) + "[");
    int index = -1;
    if (at != std::string::npos)
        std::from_chars(path.data() + at + list.size() + 1, path.data() + path.size(), index);
    return index;
}

/// Latin and Russian letters; small Russian ones are D0 B0 to D0 BF and D1 80 to D1 8F in UTF-8, their
/// capitals D0 90 to D0 AF.
std::string withCapital(std::string text) {
    const auto second = text.size() > 1 ? static_cast<unsigned char>(text[1]) : 0;
    if (text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    } else if (text.front() == '\xD0' && second >= 0xB0) {
        text[1] = static_cast<char>(second - 0x20);
    } else if (text.front() == '\xD1' && second <= 0x8F) {
        text[0] = '\xD0';
        text[1] = static_cast<char>(second + 0x20);
    }
    return text;
}

/// Whether a sentence's text begins with one of its names, which stays as it is: "earth.jpg: …".
bool beginsWithName(const Sentence& sentence, std::string_view text) {
    if (sentence.isName())
        return !sentence.empty() && text.starts_with(sentence.english());
    return std::ranges::any_of(sentence.arguments(),
                               [text](const Sentence& each) { return beginsWithName(each, text); });
}

/// Opens the list of vertices, for calls that are left out at the first vertex without one.
void revealCoords(Session& session, std::string_view path) {
    Selection& selection = session.look.selection;
    session.window.wantedTab = Tab::Vertices;
    const Model* model = selectedModel(session);
    for (std::size_t unit = 0; model && unit < maxUnits; ++unit) {
        if (path.find(findKey(memberId<&Model::texCoords>, unit)) != std::string_view::npos)
            selection.unit = static_cast<int>(unit);
        if (path.find(findKey(memberId<&Model::noTexCoord>, unit)) == std::string_view::npos)
            continue;
        selection.unit = static_cast<int>(unit);
        if (const auto first = firstWithoutCall(sentVertices(*model, meshOf(*model)), unit))
            selection.vertex = first->vertex;
    }
}

} // namespace

bool isOfCoords(std::string_view path) {
    return path.find("texCoords") != std::string_view::npos ||
           path.find("noTexCoord") != std::string_view::npos;
}

void diagnoseSession(Session& session, const DriverFacts& driver) {
    Diagnosis& last = session.document.diagnosis;
    std::vector<TexturePictures> pictures;
    const StandingScene scene(session.document.scene, session.look.playback.time);
    for (const Texture& texture : scene->textures)
        pictures.push_back(session.document.images.picturesOf(texture));
    if (last.scene == *scene && last.pictures == pictures && last.driver == driver)
        return;
    session.document.findings = diagnose(*scene, session.document.images, driver);
    last = {*scene, std::move(pictures), driver};
}

bool isUnused(const Session& session, std::string_view path) {
    return std::ranges::any_of(session.document.findings, [&](const Finding& each) {
        return each.severity == Severity::Unused && each.path == path;
    });
}

Sentence shownSentence(const Sentence& problem) {
    const std::string text = tr(Sentence("{0}.", problem));
    return ProperName{beginsWithName(problem, text) ? text : withCapital(text)};
}

void reveal(Session& session, const std::string& path) {
    Selection& selection = session.look.selection;
    if (const int pass = indexIn(path, "passes"); pass >= 0)
        selection.pass = pass;
    if (const int unit = indexIn(path, "units"); unit >= 0)
        selection.unit = unit;
    if (const int model = indexIn(path, "models"); model >= 0) {
        selection.model = model;
        if (isOfCoords(path))
            revealCoords(session, path);
    }
    // A texture is edited through a unit that it is bound to; one that is on comes first.
    if (const int texture = indexIn(path, "textures"); texture >= 0) {
        for (const bool on : {false, true}) {
            for (std::size_t p = 0; p < presentScene(session).passes.size(); ++p) {
                for (std::size_t u = 0; u < maxUnits; ++u) {
                    const Pass& pass = presentScene(session).passes[p];
                    const Unit& unit = pass.units[u];
                    if (unit.texture == texture && (pass.enabled && unit.enabled) == on) {
                        selection.pass = static_cast<int>(p);
                        selection.unit = static_cast<int>(u);
                    }
                }
            }
        }
    }
    session.out.wantedParam = path;
    session.look.shownParam = path;
}

Sentence assignmentsOf(const Fix& fix) {
    std::string lines;
    for (const edit::Set& each : fix.assignments)
        lines += fmt::format("{}{} = {}", lines.empty() ? "" : "\n", each.path, each.value);
    return ProperName{lines};
}

void applyFix(const Session& session, const Fix& fix) {
    submit(session, {.name = fix.label,
                     .edits = {fix.assignments.begin(), fix.assignments.end()},
                     .path = fix.assignments.front().path});
}

} // namespace texplorer::ui
