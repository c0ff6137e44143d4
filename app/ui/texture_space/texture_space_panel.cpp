#include "app/ui/texture_space/texture_space_panel.h"

#include "app/ui/model/explaining.h"
#include "app/ui/state/chosen_vertices.h"
#include "app/ui/texture_space/outline_drawing.h"
#include "app/ui/texture_space/plane_input.h"
#include "app/ui/texture_space/plane_legend.h"
#include "app/ui/texture_space/plane_tools.h"
#include "app/ui/texture_space/texel_insets.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "texplorer/image/cube_faces.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

/// Whether an image may have transparent texels.
bool hasAlpha(const Surface& surface) {
    if (const auto* blocks = std::get_if<BlockImage>(&surface))
        return isS3tc(blocks->format) && blocks->format != BlockFormat::Dxt1;
    const PixelFormat format = std::get<Image>(surface).format;
    return format == PixelFormat::Rgba8 || format == PixelFormat::LuminanceAlpha8 ||
           format == PixelFormat::Alpha8;
}

/// The relative height of the host's picture of a cube map's base level.
float unfoldedHeight(const TextureImage& image) {
    if (image.faces == cubeFaceCount)
        return 0.75F; // a cross, see PreviewPicture
    const int width = widthOf(image.surfaces.front());
    const int height = heightOf(image.surfaces.front());
    const bool isOneFace = cubeLayout(width, height) == CubeLayout::Same;
    return isOneFace ? 1.0F : static_cast<float>(height) / static_cast<float>(width);
}

/// The picture of the image: the host's, or the one made for the look.
TilePicture tilePicture(TextureSpaceState& state, const Pictures& pictures, const Texture& texture,
                        const std::shared_ptr<const TextureImage>& image) {
    const Surface& first = image->surfaces.front();
    const std::shared_ptr<const Image>& made = state.level.picture();
    const bool isMade = made && !state.look.isPlain();
    TilePicture shown{.handle = isMade ? pictures.showTexels(made) : pictures.texture,
                      .width = isMade ? made->width : widthOf(first),
                      .height = isMade ? made->height : heightOf(first)};
    const bool transparent = hasAlpha(first) && state.look.channel == Channel::All;
    shown.board = transparent && state.look.board;
    shown.opaque = !isMade && state.opacity.isOpaque(texture, image);
    shown.ignoresAlpha = transparent && !shown.board;
    shown.setBlending = pictures.setBlending;
    return shown;
}

void drawPicture(ImDrawList& draw, const Canvas& canvas, const Session& session, TextureSpaceState& state,
                 const Pictures& pictures) {
    const auto drawGround = [&] { draw.AddRectFilled(canvas.low, canvas.high, color::ground); };
    const Texture* texture = boundTexture(session);
    const auto image = boundImage(session);
    if (!image || image->surfaces.empty())
        return drawGround();
    const TilePicture shown = tilePicture(state, pictures, *texture, image);
    if (shown.handle == view::PictureHandle::None)
        return drawGround();
    if (selectedUnit(session).target != Target::CubeMap)
        return drawTiles(draw, canvas, *texture, shown, boundsOf(state.coords));
    drawGround();
    const bool isMade = shown.handle != pictures.texture;
    drawUnfolded(draw, canvas, shown.handle,
                 isMade ? static_cast<float>(shown.height) / static_cast<float>(shown.width)
                        : unfoldedHeight(*image));
}

OutlineMarks marksNow(const Session& session, const std::optional<Grip>& grip) {
    OutlineMarks marks{session.look.selection.vertex, chosenVertices(session.look.selection), {}};
    const std::optional<PickedVertex>& elsewhere = session.look.hoveredInView;
    if (grip)
        marks.hovered = grip->vertex;
    else if (elsewhere && std::cmp_equal(elsewhere->model, session.look.selection.model))
        marks.hovered = elsewhere->vertex;
    return marks;
}

/// The positions of the selected vertices; only the first of very many.
std::vector<ImVec2> chosenPlaces(const Session& session, const PlaneCoords& coords, const Canvas& canvas) {
    constexpr std::size_t maxPlaces = 64;
    std::vector<ImVec2> places;
    for (const std::size_t vertex : chosenVertices(session.look.selection)) {
        if (places.size() < maxPlaces && vertex < coords.resultingPlaces().size())
            places.push_back(canvas.toPixel(coords.resultingPlaces()[vertex]));
    }
    return places;
}

void noteCoordPlaces(const Canvas& canvas, const PlaneCoords& coords) {
    if (!arePlacesWanted())
        return;
    const auto noteAt = [&](const char* name, std::size_t vertex, glm::vec2 place) {
        const ImVec2 at = canvas.toPixel(place);
        noteDrawn(fmt::format("{}:{}", name, vertex), at, at);
    };
    for (std::size_t vertex = 0; vertex < coords.givenPlaces().size(); ++vertex) {
        noteAt("coord", vertex, coords.givenPlaces()[vertex]);
        noteAt("end", vertex, coords.resultingPlaces()[vertex]);
    }
}

void drawCanvas(const Session& session, TextureSpaceState& state, const Pictures& pictures) {
    const ImVec2 topLeft = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(1.0F, ImGui::GetContentRegionAvail().x),
                      std::max(1.0F, ImGui::GetContentRegionAvail().y));
    ImGui::InvisibleButton("canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    noteItem("texture space");
    const ImGuiIO& io = ImGui::GetIO();
    const Target target = selectedUnit(session).target;
    const Mesh& mesh = selectedMesh(session);
    Canvas canvas(topLeft, size, session.look.plane);
    const float margin = ImGui::GetFontSize() * 0.4F;
    const PlaneLegend legend =
        legendOf(session, state, topLeft + ImVec2(margin, margin), size.x - 2 * margin);
    canvas.legend = legend.box;
    canvas.chosen = chosenPlaces(session, state.coords, canvas);

    const std::vector<Inset> insets = insetsOf(probedUnit(session), canvas);
    PlaneMouse mouse{
        .hovered = ImGui::IsItemHovered(),
        .active = ImGui::IsItemActive(),
        .onPatch = std::ranges::any_of(insets, [&](const Inset& inset) { return inset.holds(io.MousePos); }),
        .grip = {}};
    if ((mouse.hovered || mouse.active) && !mouse.onPatch)
        mouse.grip = gripUnder(canvas, mesh, state.coords, session.look.selection.vertex, io.MousePos);
    std::optional<PickedVertex> under;
    if (mouse.grip && mouse.hovered)
        under = PickedVertex{static_cast<std::size_t>(session.look.selection.model), mouse.grip->vertex};
    if (session.look.hoveredInPlane != under)
        act(session, [under](Session& changed) { changed.look.hoveredInPlane = under; });
    const bool ended = handlePlaneInput(session, state, canvas, mouse);
    session.out.movesVertices = state.move.has_value();
    if (mouse.grip && mouse.grip->vertex >= state.coords.given().size())
        mouse.grip.reset();
    if (mouse.grip)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(canvas.low, canvas.high, true);
    drawPicture(draw, canvas, session, state, pictures);
    const OutlineMarks marks = marksNow(session, mouse.grip);
    const bool hasPlaces = !state.coords.given().empty();
    if (target != Target::CubeMap)
        drawAxes(draw, canvas);
    if (hasPlaces && state.coords.differ())
        drawGivenOutlines(draw, canvas, mesh, state.coords, marks);
    if (hasPlaces) {
        drawOutlines(draw, canvas, mesh, state.coords, marks);
        drawVertexTexts(draw, canvas, state.coords, marks, state.numbers);
    }
    const bool clicked = mouse.hovered && !mouse.grip && !ended &&
                         ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !io.KeyShift && !isDrag();
    drawTexelMarks(session, draw, canvas, insets, clicked, state.look.board);
    drawPlaneLegend(draw, legend);
    if (const std::optional<Box> box = selectionBox(state, canvas)) {
        draw.AddRect(box->low, box->high, color::shade, 0, 0, 3);
        draw.AddRect(box->low, box->high, color::chosen);
    }
    if (state.move)
        drawMoveHint(draw, canvas, *state.move);
    draw.PopClipRect();
    noteCoordPlaces(canvas, state.coords);
}

} // namespace

void drawTextureSpacePanel(const Session& session, TextureSpaceState& state, const Pictures& pictures,
                           const Layout& layout) {
    beginPanel(N_("Texture space"), layout.texture,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    state.coords.follow(session);
    drawPlaneTools(session, state);
    drawCanvas(session, state, pictures);
    ImGui::End();
}

} // namespace texplorer::ui
