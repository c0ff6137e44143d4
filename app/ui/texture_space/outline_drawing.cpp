#include "app/ui/texture_space/outline_drawing.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace texplorer::ui {
namespace {

// These limits keep the worst case below 65536 vertices: a line has 4, a round dot about 30, a letter 4.
constexpr std::size_t maxFineEdges = 1000; // with more, lines have no shade
constexpr std::size_t maxRoundDots = 300;
constexpr std::size_t maxEdges = 3000; // with more, only the selected faces are drawn, if they have no more
constexpr std::size_t maxStrongEdges = 500; // of a selected face
constexpr std::size_t maxGivenEdges = 1000;
constexpr std::size_t maxChosenDots = 2000;
constexpr std::size_t maxNumbers = 200; // of visible vertices

/// The width of a line of this many pixels at a content scale of 1; an integer, because such lines are
/// cheapest.
float strokeWidth(float pixels) {
    return std::max(1.0F, std::round(pixels * ImGui::GetFontSize() / 15));
}

/// A line that is visible on any picture: it has a dark and a bright border.
struct Stroke {
    ImU32 tint;
    float width;
    ImU32 dark = 0;  ///< around it; 0: none
    ImU32 light = 0; ///< between the two
};

void drawEdge(ImDrawList& draw, ImVec2 from, ImVec2 to, const Stroke& stroke) {
    const float halo = strokeWidth(1);
    if (stroke.dark != 0)
        draw.AddLine(from, to, stroke.dark, stroke.width + (stroke.light != 0 ? 4 : 2) * halo);
    if (stroke.light != 0)
        draw.AddLine(from, to, stroke.light, stroke.width + 2 * halo);
    draw.AddLine(from, to, stroke.tint, stroke.width);
}

/// Ordered, for sorting.
using Place = std::array<float, 2>;

Place asPlace(glm::vec2 place) {
    return {place.x, place.y};
}

void sortUnique(auto& list) {
    std::ranges::sort(list);
    const auto [rest, end] = std::ranges::unique(list);
    list.erase(rest, end);
}

/// Edges of many faces. An edge of several faces, as of neighbours and of the sides of a cube, is drawn once.
class Edges {
public:
    void add(glm::vec2 from, glm::vec2 to) {
        if (isPlace(from) && isPlace(to))
            list_.emplace_back(std::minmax(asPlace(from), asPlace(to)));
    }
    void draw(ImDrawList& draw, const Canvas& canvas, const Stroke& stroke) {
        sortUnique(list_);
        for (const auto& [from, to] : list_)
            drawEdge(draw, canvas.toPixel(from[0], from[1]), canvas.toPixel(to[0], to[1]), stroke);
    }

private:
    std::vector<std::pair<Place, Place>> list_;
};

void addOutline(Edges& edges, const Face& face, std::span<const glm::vec2> places) {
    const std::size_t count = face.vertices.size();
    const std::size_t sides = face.closed ? count : count - std::min<std::size_t>(count, 1);
    for (std::size_t i = 0; i < sides; ++i)
        edges.add(places[face.vertices[i]], places[face.vertices[(i + 1) % count]]);
}

/// The common edge of the two triangles of a quadrilateral: see Mesh.
void addDiagonal(Edges& edges, const Face& face, std::span<const glm::vec2> places) {
    if (face.closed && face.vertices.size() == 4)
        edges.add(places[face.vertices[1]], places[face.vertices[3]]);
}

/// A diamond marks a selected vertex, so that it is not distinguished only by its colour. Squares are
/// cheapest.
enum class DotShape : std::uint8_t { Square, Round, Diamond };

void drawDiamond(ImDrawList& draw, ImVec2 at, float radius, ImU32 tint) {
    draw.AddQuadFilled({at.x, at.y - radius}, {at.x + radius, at.y}, {at.x, at.y + radius},
                       {at.x - radius, at.y}, tint);
}

void drawVertexDot(ImDrawList& draw, ImVec2 at, float radius, ImU32 tint, DotShape shape) {
    const float halo = strokeWidth(1);
    switch (shape) {
    case DotShape::Square:
        return draw.AddRectFilled(at - ImVec2(radius, radius), at + ImVec2(radius, radius), tint);
    case DotShape::Round:
        draw.AddCircleFilled(at, radius + halo, color::shade, 12);
        return draw.AddCircleFilled(at, radius, tint, 12);
    case DotShape::Diamond:
        constexpr float larger = 1.4F; // to have a circle's area
        drawDiamond(draw, at, radius * larger + 2 * halo, color::shade);
        return drawDiamond(draw, at, radius * larger, tint);
    }
}

/// The distance between the vertices of an evenly divided mesh, in pixels. The vertices of a cube, several of
/// which share a place, count as one face.
float spacingOf(const Canvas& canvas, std::span<const glm::vec2> places) {
    constexpr std::size_t few = 30;
    Bounds bounds{glm::vec2(INFINITY), glm::vec2(-INFINITY)};
    for (const glm::vec2& each : places)
        if (isPlace(each))
            bounds.include(each);
    if (places.size() <= few || !(bounds.low.x <= bounds.high.x))
        return INFINITY;
    const glm::vec2 extent = (bounds.high - bounds.low) * canvas.pixelsPerUnit;
    return std::sqrt(std::max(extent.x, 1.0F) * std::max(extent.y, 1.0F) / static_cast<float>(places.size()));
}

/// An arrow with a filled head and a thin shaft.
void drawArrow(ImDrawList& draw, ImVec2 from, ImVec2 to, ImU32 tint) {
    const float em = ImGui::GetFontSize();
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const float head = em * 0.5F;
    if (!(length > 2 * head))
        return;
    const ImVec2 way((to.x - from.x) / length, (to.y - from.y) / length);
    const ImVec2 tip = to - way * (em * 0.35F); // with space up to the dot
    const ImVec2 neck = tip - way * head;
    drawEdge(draw, from, neck, {tint, strokeWidth(1), color::shade});
    const ImVec2 side = ImVec2(-way.y, way.x) * head * 0.45F;
    draw.AddTriangleFilled(tip, neck + side, neck - side, tint);
}

std::size_t edgeCount(const Mesh& mesh) {
    std::size_t edges = 0;
    for (const Face& face : mesh.faces)
        edges += face.vertices.size();
    return edges;
}

/// "2   (1.00, 0.50)", and its end point; "2 = 1" if it has the coordinates of vertex 1.
Sentence vertexText(const PlaneCoords& coords, std::size_t vertex) {
    const glm::vec4 given = coords.current(vertex);
    const std::optional<std::uint32_t> source = coords.source(vertex);
    const std::string numbers =
        source.value_or(vertex) == vertex ? std::to_string(vertex) : fmt::format("{} = {}", vertex, *source);
    const ProperName name{numbers};
    const glm::vec2 end = coords.resultingPlaces()[vertex];
    if (!coords.differ() && given.q == 1)
        return {N_("{0}   ({1:.2f}, {2:.2f})"), name, given.s, given.t};
    if (!isPlace(end))
        return {N_("{0}   ({1:.2f}, {2:.2f}) → nowhere: q is 0"), name, given.s, given.t};
    if (given.q != 1)
        return {N_("{0}   ({1:.2f}, {2:.2f}, q {3:.2f}) → ({4:.2f}, {5:.2f})"),
                name,
                given.s,
                given.t,
                given.q,
                end.x,
                end.y};
    return {N_("{0}   ({1:.2f}, {2:.2f}) → ({3:.2f}, {4:.2f})"), name, given.s, given.t, end.x, end.y};
}

/// Vertices at one place.
struct Spot {
    ImVec2 at;
    std::vector<std::size_t> vertices;
};

/// The visible ones; none if there are too many for names.
std::vector<Spot> spotsInSight(const Canvas& canvas, std::span<const glm::vec2> places) {
    std::vector<Spot> spots;
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
        if (!isPlace(places[vertex]))
            continue;
        const ImVec2 at = canvas.toPixel(places[vertex]);
        if (!canvas.holds(at))
            continue;
        if (++count > maxNumbers)
            return {};
        const auto same = std::ranges::find_if(spots, [at](const Spot& spot) {
            return std::abs(spot.at.x - at.x) < 2 && std::abs(spot.at.y - at.y) < 2;
        });
        if (same == spots.end())
            spots.push_back({at, {vertex}});
        else
            same->vertices.push_back(vertex);
    }
    return spots;
}

/// The number of the selected vertex, or of the first ones.
std::string numbersOf(const Spot& spot, const OutlineMarks& marks) {
    std::vector<std::size_t> named;
    for (const std::size_t vertex : spot.vertices) {
        if (std::ranges::binary_search(marks.chosen, vertex))
            named.push_back(vertex);
    }
    if (named.empty())
        named = spot.vertices;
    constexpr std::size_t maxNames = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(named.size(), maxNames); ++i)
        text += (i == 0 ? "" : " ") + std::to_string(named[i]);
    return named.size() > maxNames ? text + " …" : text;
}

} // namespace

bool contains(const Face& face, std::optional<std::size_t> vertex) {
    return vertex && std::ranges::find(face.vertices, *vertex) != face.vertices.end();
}

bool leavesOutOutlines(const Mesh& mesh) {
    return edgeCount(mesh) > maxEdges;
}

void drawGivenOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                       const OutlineMarks& marks) {
    const std::vector<glm::vec2>& places = coords.givenPlaces();
    const std::size_t edges = edgeCount(mesh);
    const float dot = ImGui::GetFontSize() * 0.2F;
    const ImU32 faint = faded(color::text, 0.55F);
    Edges faintEdges;
    Edges chosenEdges;
    for (const Face& face : mesh.faces) {
        const bool isChosen = contains(face, marks.vertex);
        if ((isChosen ? face.vertices.size() : edges) <= maxGivenEdges)
            addOutline(isChosen ? chosenEdges : faintEdges, face, places);
    }
    faintEdges.draw(draw, canvas, {faint, strokeWidth(1), faded(color::shade, 0.5F)});
    chosenEdges.draw(draw, canvas, {faded(color::chosen, 0.55F), strokeWidth(1), faded(color::shade, 0.5F)});
    if (places.size() <= maxRoundDots) {
        for (const glm::vec2& each : places)
            draw.AddCircle(canvas.toPixel(each), dot, faint, 12, strokeWidth(1));
    }
    if (!marks.vertex || *marks.vertex >= places.size())
        return;
    const glm::vec2 given = places[*marks.vertex];
    const glm::vec2 end = coords.resultingPlaces()[*marks.vertex];
    draw.AddCircle(canvas.toPixel(given), dot, color::chosen, 12, strokeWidth(1.5F));
    if (isPlace(end))
        drawArrow(draw, canvas.toPixel(given), canvas.toPixel(end), faded(color::chosen, 0.8F));
}

void drawOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                  const OutlineMarks& marks) {
    const float em = ImGui::GetFontSize();
    const std::vector<glm::vec2>& places = coords.resultingPlaces();
    const std::size_t edges = edgeCount(mesh);
    const float spacing = spacingOf(canvas, places);
    const bool fine = edges <= maxFineEdges && spacing >= em * 0.7F;
    const bool round = places.size() <= maxRoundDots;
    const Stroke line{faded(color::text, fine ? 0.95F : 0.7F), strokeWidth(1),
                      fine ? ImU32(color::shade) : 0U};
    const Stroke diagonal{faded(color::text, 0.4F), 1, fine ? faded(color::shade, 0.4F) : 0U};
    Edges lines;
    Edges diagonals;
    Edges thinChosen; // of a face with very many edges
    Edges strongChosen;
    Edges chosenDiagonals;
    for (std::size_t i = 0; i < std::min(mesh.faces.size(), coords.outlines().size()); ++i) {
        const Face& face = coords.outlines()[i];
        const std::size_t count = face.vertices.size();
        const bool isChosen = contains(mesh.faces[i], marks.vertex);
        if (isChosen && count <= maxEdges) {
            addDiagonal(chosenDiagonals, face, coords.outlinePlaces());
            addOutline(count <= maxStrongEdges ? strongChosen : thinChosen, face, coords.outlinePlaces());
        } else if (!isChosen && edges <= maxEdges) {
            if (round)
                addDiagonal(diagonals, face, coords.outlinePlaces());
            addOutline(lines, face, coords.outlinePlaces());
        }
    }
    diagonals.draw(draw, canvas, diagonal);
    lines.draw(draw, canvas, line);
    chosenDiagonals.draw(draw, canvas, {faded(color::chosen, 0.7F), 1, faded(color::shade, 0.6F)});
    thinChosen.draw(draw, canvas, {color::chosen, strokeWidth(2)});
    strongChosen.draw(draw, canvas, {color::chosen, strokeWidth(2), color::shade, faded(color::text, 0.7F)});
    const auto isShown = [&](std::size_t vertex) {
        return vertex < places.size() && isPlace(places[vertex]);
    };
    const auto dotOf = [&](std::size_t vertex, float radius, DotShape shape) {
        if (isShown(vertex))
            drawVertexDot(draw, canvas.toPixel(places[vertex]), radius, color::chosen, shape);
    };
    const float dot = em * (places.size() <= 100 ? 0.22F : 0.13F);
    if (edges <= maxEdges && spacing >= 5 * dot) {
        std::vector<Place> once; // the sides of a cube have equal ones
        for (const glm::vec2& each : places)
            if (isPlace(each))
                once.push_back(asPlace(each));
        sortUnique(once);
        for (const Place& each : once)
            drawVertexDot(draw, canvas.toPixel(each[0], each[1]), dot, color::text,
                          round ? DotShape::Round : DotShape::Square);
    }
    for (std::size_t i = 0; i < std::min(marks.chosen.size(), maxChosenDots); ++i)
        dotOf(marks.chosen[i], em * (marks.chosen.size() <= 100 ? 0.24F : 0.16F),
              marks.chosen.size() <= maxRoundDots ? DotShape::Diamond : DotShape::Square);
    if (marks.vertex)
        dotOf(*marks.vertex, em * 0.3F, DotShape::Diamond);
    if (marks.hovered && isShown(*marks.hovered)) {
        const ImVec2 at = canvas.toPixel(places[*marks.hovered]);
        draw.AddCircle(at, em * 0.5F, color::shade, 24, strokeWidth(4));
        draw.AddCircle(at, em * 0.5F, color::chosen, 24, strokeWidth(2));
        noteDrawn(N_("hover ring"), at, at);
    }
}

void drawVertexTexts(ImDrawList& draw, const Canvas& canvas, const PlaneCoords& coords,
                     const OutlineMarks& marks, bool numbers) {
    const float em = ImGui::GetFontSize();
    const std::vector<glm::vec2>& places = coords.resultingPlaces();
    std::vector<Box> taken{canvas.legend};
    std::vector<std::size_t> named;
    if (marks.hovered)
        named.push_back(*marks.hovered);
    if (marks.vertex && marks.vertex != marks.hovered)
        named.push_back(*marks.vertex);
    const auto isFree = [&taken](const Box& box) {
        return std::ranges::none_of(taken, [&box](const Box& each) { return overlaps(box, each); });
    };
    for (const std::size_t vertex : named) {
        if (vertex >= places.size())
            continue;
        const glm::vec2 place = isPlace(places[vertex]) ? places[vertex] : coords.givenPlaces()[vertex];
        const ImVec2 at = canvas.toPixel(place);
        if (!canvas.holds(at))
            continue;
        const Sentence english = vertexText(coords, vertex);
        const std::string words = tr(english);
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        // Next to the vertex, inside of the panel: above it, or else below.
        const float x = std::clamp(at.x + em * 0.7F, canvas.low.x + em * 0.4F,
                                   std::max(canvas.low.x + em * 0.4F, canvas.high.x - size.x - em * 0.4F));
        std::optional<Box> found;
        for (const float y : {at.y - size.y - em * 0.6F, at.y + em * 0.6F}) {
            const Box box = chipBox({x, y}, size);
            if (box.low.y < canvas.low.y || box.high.y > canvas.high.y || box.high.x > canvas.high.x)
                continue;
            found = box;
            if (isFree(box))
                break;
        }
        if (!found) // the panel is smaller than the label
            continue;
        taken.push_back(*found);
        drawTextChip(draw, *found, em, color::chosen, words);
        noteDrawn(N_("coord label:") + english.english(), found->low, found->high);
    }
    const float size = em * 0.85F;
    const ImVec2 centre = canvas.toPixel(canvas.plane.s, canvas.plane.t);
    for (const Spot& spot : numbers ? spotsInSight(canvas, places) : std::vector<Spot>{}) {
        if (std::ranges::find_first_of(spot.vertices, named) != spot.vertices.end())
            continue;
        const std::string text = numbersOf(spot, marks);
        const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, 10000, 0, text.c_str());
        const float gap = em * 0.4F; // towards the middle, where there is more room than outside of the image
        const ImVec2 at(spot.at.x <= centre.x ? spot.at.x + gap : spot.at.x - gap - extent.x,
                        spot.at.y > centre.y ? spot.at.y - gap - extent.y : spot.at.y + gap);
        const Box box = chipBox(at, extent);
        if (!isFree(box))
            continue;
        taken.push_back(box);
        const bool isChosen = std::ranges::any_of(spot.vertices, [&](std::size_t vertex) {
            return std::ranges::binary_search(marks.chosen, vertex);
        });
        drawTextChip(draw, box, size, isChosen ? color::chosen : color::text, text);
        noteDrawn(N_("vertex number:") + text, box.low, box.high);
    }
}

} // namespace texplorer::ui
