#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/theme.h"
#include "app/ui/tiling.h"
#include "core/scene/tex_coords.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr int farthestTile = 100; // how many copies of the image are drawn along one axis, at most
constexpr float nearestExtent = 0.02F;
constexpr float farthestExtent = 200;

/// From texture coordinates to pixels and back. t grows upwards.
struct Canvas {
    ImVec2 low, high;
    Plane plane;
    float pixelsPerUnit;

    Canvas(ImVec2 topLeft, ImVec2 size, const Plane& seen)
        : low(topLeft)
        , high(topLeft.x + size.x, topLeft.y + size.y)
        , plane(seen)
        , pixelsPerUnit(std::min(size.x, size.y) / seen.extent) {}

    [[nodiscard]] ImVec2 toPixel(float s, float t) const {
        return {(low.x + high.x) / 2 + (s - plane.s) * pixelsPerUnit,
                (low.y + high.y) / 2 - (t - plane.t) * pixelsPerUnit};
    }
    [[nodiscard]] glm::vec2 toCoord(ImVec2 pixel) const {
        return {plane.s + (pixel.x - (low.x + high.x) / 2) / pixelsPerUnit,
                plane.t - (pixel.y - (low.y + high.y) / 2) / pixelsPerUnit};
    }
};

bool hasAlpha(const Image& image) {
    return image.format == PixelFormat::Alpha8 || image.format == PixelFormat::LuminanceAlpha8 ||
           image.format == PixelFormat::Rgba8;
}

/// A board behind what is transparent.
void drawBoard(ImDrawList& draw, ImVec2 low, ImVec2 high, float cell) {
    draw.AddRectFilled(low, high, IM_COL32(62, 66, 73, 255));
    for (int row = 0; low.y + static_cast<float>(row) * cell < high.y; ++row) {
        for (float x = low.x + (row % 2 == 0 ? 0 : cell); x < high.x; x += 2 * cell) {
            const float y = low.y + static_cast<float>(row) * cell;
            draw.AddRectFilled({x, y}, {std::min(x + cell, high.x), std::min(y + cell, high.y)},
                               IM_COL32(84, 89, 97, 255));
        }
    }
}

void drawTiles(ImDrawList& draw, const Canvas& canvas, const Texture& texture, const Image& image,
               unsigned id) {
    const glm::vec2 from = canvas.toCoord({canvas.low.x, canvas.high.y});
    const glm::vec2 to = canvas.toCoord({canvas.high.x, canvas.low.y});
    const auto tile = [](float coord) {
        return static_cast<int>(std::clamp(std::floor(coord), -1.0F * farthestTile, 1.0F * farthestTile));
    };
    const ImU32 border = ImGui::ColorConvertFloat4ToU32(
        {texture.borderColor.x, texture.borderColor.y, texture.borderColor.z, texture.borderColor.w});
    for (int j = tile(from.y); j <= tile(to.y); ++j) {
        for (int i = tile(from.x); i <= tile(to.x); ++i) {
            const auto s = tileSpan(texture.wrapS, i, image.width);
            const auto t = tileSpan(texture.wrapT, j, image.height);
            const ImVec2 low = canvas.toPixel(static_cast<float>(i), static_cast<float>(j + 1));
            const ImVec2 high = canvas.toPixel(static_cast<float>(i + 1), static_cast<float>(j));
            // What wrapping makes of the surroundings is a little darker than the image.
            const bool itself = i == 0 && j == 0;
            if (!s || !t)
                draw.AddRectFilled(low, high, border);
            else
                draw.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(id)), low, high,
                              {s->from, t->to}, {s->to, t->from});
            if (!itself)
                draw.AddRectFilled(low, high, IM_COL32(20, 22, 27, 105));
        }
    }
}

/// s in red along the bottom edge of the image, t in green along its left edge, both with an arrow beyond 1.
void drawAxes(ImDrawList& draw, const Canvas& canvas) {
    const float em = ImGui::GetFontSize();
    const float beyond = em * 1.6F;
    const float thick = std::max(1.5F, em / 8);
    const ImVec2 origin = canvas.toPixel(0, 0);
    const ImVec2 s(canvas.toPixel(1, 0).x + beyond, origin.y);
    const ImVec2 t(origin.x, canvas.toPixel(0, 1).y - beyond);
    const float head = em * 0.35F;
    draw.AddLine(origin, s, color::shade, thick + 2);
    draw.AddLine(origin, t, color::shade, thick + 2);
    draw.AddLine(origin, s, color::s, thick);
    draw.AddLine(origin, t, color::t, thick);
    draw.AddTriangleFilled({s.x + 2 * head, s.y}, {s.x, s.y - head}, {s.x, s.y + head}, color::s);
    draw.AddTriangleFilled({t.x, t.y - 2 * head}, {t.x + head, t.y}, {t.x - head, t.y}, color::t);
    const auto label = [&](ImVec2 at, ImU32 tint, const char* text) {
        const ImVec2 size = ImGui::CalcTextSize(text);
        const float pad = em * 0.2F;
        draw.AddRectFilled({at.x - pad, at.y}, {at.x + size.x + pad, at.y + size.y}, color::shade, pad);
        draw.AddText(at, tint, text);
    };
    label({s.x - em * 0.2F, s.y + em * 0.5F}, color::s, "s");
    label({t.x - em * 1.3F, t.y - em * 0.4F}, color::t, "t");
    label({canvas.toPixel(1, 0).x - em * 0.3F, s.y + em * 0.5F}, color::text, "1");
    label({t.x - em * 1.3F, canvas.toPixel(0, 1).y - em * 0.4F}, color::text, "1");
    label({origin.x - em * 1.1F, origin.y + em * 0.5F}, color::text, "0");
}

void drawFace(ImDrawList& draw, const Canvas& canvas, const Face& face, const TexCoords& coords, ImU32 tint,
              float thickness) {
    const std::size_t count = face.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec4& a = coords[face.vertices[i]];
        const glm::vec4& b = coords[face.vertices[(i + 1) % count]];
        const ImVec2 from = canvas.toPixel(a.x, a.y);
        const ImVec2 to = canvas.toPixel(b.x, b.y);
        draw.AddLine(from, to, color::shade, thickness + 2);
        draw.AddLine(from, to, tint, thickness);
    }
}

bool contains(const Face& face, std::size_t vertex) {
    return std::ranges::find(face.vertices, static_cast<std::uint32_t>(vertex)) != face.vertices.end();
}

/// The vertex under the mouse. Where several share a place (the faces of a cube do), the chosen one comes
/// first, then one of its face.
std::optional<std::size_t> vertexUnder(const Canvas& canvas, const Mesh& mesh, const TexCoords& coords,
                                       std::optional<std::size_t> chosen, ImVec2 mouse, float reach) {
    const auto isNear = [&](std::size_t vertex) {
        const ImVec2 at = canvas.toPixel(coords[vertex].x, coords[vertex].y);
        return std::hypot(at.x - mouse.x, at.y - mouse.y) <= reach;
    };
    if (chosen && *chosen < coords.size() && isNear(*chosen))
        return chosen;
    if (chosen) {
        for (const Face& face : mesh.faces) {
            if (!contains(face, *chosen))
                continue;
            for (const std::uint32_t vertex : face.vertices) {
                if (isNear(vertex))
                    return vertex;
            }
        }
    }
    for (std::size_t vertex = 0; vertex < coords.size(); ++vertex) {
        if (isNear(vertex))
            return vertex;
    }
    return std::nullopt;
}

void moveCanvas(Plane& plane, const Canvas& canvas, bool hovered, bool dragged) {
    const ImGuiIO& io = ImGui::GetIO();
    if (dragged) {
        plane.s -= io.MouseDelta.x / canvas.pixelsPerUnit;
        plane.t += io.MouseDelta.y / canvas.pixelsPerUnit;
    }
    if (hovered && io.MouseWheel != 0) {
        // What is under the mouse stays there.
        const glm::vec2 fixed = canvas.toCoord(io.MousePos);
        const float extent =
            std::clamp(plane.extent * std::pow(0.9F, io.MouseWheel), nearestExtent, farthestExtent);
        const float factor = extent / plane.extent;
        plane.s = fixed.x + (plane.s - fixed.x) * factor;
        plane.t = fixed.y + (plane.t - fixed.y) * factor;
        plane.extent = extent;
    }
}

void fitPlane(Plane& plane, const TexCoords& coords) {
    glm::vec2 low(0);
    glm::vec2 high(1);
    for (const glm::vec4& each : coords) {
        low = glm::min(low, glm::vec2(each));
        high = glm::max(high, glm::vec2(each));
    }
    plane.s = (low.x + high.x) / 2;
    plane.t = (low.y + high.y) / 2;
    plane.extent = std::clamp(std::max(high.x - low.x, high.y - low.y) * 1.4F, nearestExtent, farthestExtent);
}

void drawCanvas(Session& session, const Pictures& pictures) {
    const ImVec2 topLeft = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(1.0F, ImGui::GetContentRegionAvail().x),
                      std::max(1.0F, ImGui::GetContentRegionAvail().y));
    ImGui::InvisibleButton("canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    noteItem(session, "texture space");
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    const bool let_go = ImGui::IsItemDeactivated();
    const ImGuiIO& io = ImGui::GetIO();
    const float em = ImGui::GetFontSize();

    const Canvas canvas(topLeft, size, session.plane);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(canvas.low, canvas.high, true);
    draw.AddRectFilled(canvas.low, canvas.high, color::ground);

    const Texture* texture = boundTexture(std::as_const(session));
    const std::shared_ptr<const Image> image = texture ? session.images.find(*texture) : nullptr;
    if (image && pictures.texture != 0) {
        if (hasAlpha(*image))
            drawBoard(draw, canvas.low, canvas.high, em * 0.8F);
        drawTiles(draw, canvas, *texture, *image, pictures.texture);
    }
    Model* model = selectedModel(session);
    const Mesh& mesh = selectedMesh(session);
    if (model) {
        const TexCoords coords = effectiveTexCoords(*model, mesh, session.selection.unit);
        std::optional<std::size_t>& chosen = session.selection.vertex;
        const auto under = hovered || active
                               ? vertexUnder(canvas, mesh, coords, chosen, io.MousePos, em * 0.55F)
                               : std::optional<std::size_t>{};
        if (ImGui::IsItemActivated()) {
            if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
                chosen = under;
            session.movesVertex = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && under.has_value();
        }
        const bool dragged = active && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
        if (dragged && session.movesVertex && chosen && *chosen < coords.size()) {
            glm::vec4 moved = coords[*chosen];
            moved.x += io.MouseDelta.x / canvas.pixelsPerUnit;
            moved.y -= io.MouseDelta.y / canvas.pixelsPerUnit;
            setTexCoord(*model, mesh, session.selection.unit, *chosen, moved);
            recordEdit(session, "Move vertex " + std::to_string(*chosen),
                       "models[" + std::to_string(session.selection.model) + "].texCoords" +
                           std::to_string(session.selection.unit));
        }
        if (let_go)
            sealEdit(session);
        moveCanvas(session.plane, canvas, hovered, dragged && !session.movesVertex);

        for (const Face& face : mesh.faces) {
            if (!chosen || !contains(face, *chosen))
                drawFace(draw, canvas, face, coords, color::outline, 1);
        }
        for (const Face& face : mesh.faces) {
            if (chosen && contains(face, *chosen))
                drawFace(draw, canvas, face, coords, color::chosen, std::max(1.5F, em / 9));
        }
        drawAxes(draw, canvas);
        const float dot = em * (coords.size() > 100 ? 0.13F : 0.24F);
        for (std::size_t vertex = 0; vertex < coords.size(); ++vertex) {
            const ImVec2 at = canvas.toPixel(coords[vertex].x, coords[vertex].y);
            if (session.probe)
                session.probe->items["coord:" + std::to_string(vertex)] = {at.x, at.y, at.x, at.y, true};
            if (chosen == vertex)
                continue;
            draw.AddCircleFilled(at, dot + 1, color::shade);
            draw.AddCircleFilled(at, dot, under == vertex ? color::chosen : color::text);
        }
        if (chosen && *chosen < coords.size()) {
            const ImVec2 at = canvas.toPixel(coords[*chosen].x, coords[*chosen].y);
            draw.AddCircleFilled(at, em * 0.4F, color::shade);
            draw.AddCircleFilled(at, em * 0.3F, color::chosen);
        }
        if (under)
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    } else {
        drawAxes(draw, canvas);
        moveCanvas(session.plane, canvas, hovered, active);
    }
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && model)
        fitPlane(session.plane, effectiveTexCoords(*model, mesh, session.selection.unit));
    draw.PopClipRect();
}

} // namespace

void drawTextureSpacePanel(Session& session, const Pictures& pictures, const Layout& layout) {
    beginPanel("Texture space", layout.texture,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Texture space");
    const Texture* texture = boundTexture(std::as_const(session));
    const std::shared_ptr<const Image> image = texture ? session.images.find(*texture) : nullptr;
    const std::string what = "unit " + std::to_string(session.selection.unit) + " · " +
                             (image ? std::to_string(image->width) + " × " + std::to_string(image->height)
                                    : std::string("no texture"));
    const float button = ImGui::CalcTextSize("Fit").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(what.c_str()).x + button)
        ImGui::TextDisabled("%s", what.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
    if (ImGui::Button("Fit")) {
        const Model* model = selectedModel(session);
        fitPlane(session.plane,
                 model ? effectiveTexCoords(*model, selectedMesh(session), session.selection.unit)
                       : TexCoords{});
    }
    noteItem(session, "fit plane");
    helpTip("Shows the image and every vertex. Drag a vertex to move its coordinates, drag elsewhere to pan, "
            "turn the "
            "wheel to zoom.");
    drawCanvas(session, pictures);
    ImGui::End();
}

} // namespace texplorer::ui
