#include "app/ui/view/probed_pixel.h"

#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

/// The colour of the probed things, as strong as the texel's share.
std::shared_ptr<const Image> lightFrom(const reference::Contributions& found) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, found.width, found.height);
    const ImVec4 tint = ImGui::ColorConvertU32ToFloat4(color::probed);
    float most = 0;
    for (const float weight : found.weights)
        most = std::max(most, weight);
    const auto byte = [](float value) {
        return static_cast<std::byte>(static_cast<int>(value * 255 + 0.5F));
    };
    for (std::size_t i = 0; i < found.weights.size(); ++i) {
        const float weight = found.weights[i];
        const float alpha = weight > 0 ? 0.25F + 0.65F * weight / most : 0;
        const std::array color{byte(tint.x), byte(tint.y), byte(tint.z), byte(alpha)};
        std::ranges::copy(color, image.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return std::make_shared<const Image>(std::move(image));
}

reference::DrawRequest pictureNow(const Session& session, int width, int height) {
    return {session.scene, session.images, session.playback.time, width, height, session.views.anisotropy};
}

/// The image in which the unit that is asked about would look up the texel now.
std::shared_ptr<const TextureImage> imageAsked(const Session& session) {
    const Scene& scene = session.scene;
    const reference::TexelQuestion& asked = *session.explaining.texel;
    const auto pass = static_cast<std::size_t>(asked.pass);
    if (pass >= scene.passes.size())
        return nullptr;
    const int index = scene.passes[pass].units[static_cast<std::size_t>(asked.unit)].texture;
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < scene.textures.size();
    return exists ? session.images.find(scene.textures[static_cast<std::size_t>(index)]) : nullptr;
}

} // namespace

void askAboutPicture(Session& session, const Pictures& pictures) {
    Explaining& asked = session.explaining;
    if (asked.texel && asked.texelOf != imageAsked(session))
        clearTexel(session);
    if (pictures.views.empty())
        return;
    const auto [width, height] = pictures.views.front().frame.size;
    if (asked.pixel && (asked.pixel->x >= width || asked.pixel->y >= height))
        asked.pixel.reset();
    if ((!asked.pixel && !asked.texel) || width < 1 || height < 1) {
        asked.answer.reset();
        asked.light.reset();
        asked.lightOf.reset();
        probeWorkerOf(session).rest();
        return;
    }
    asked.answer =
        probeWorkerOf(session).answer({pictureNow(session, width, height), asked.pixel, asked.texel});
    if (asked.lightOf == asked.answer)
        return;
    asked.lightOf = asked.answer;
    const bool lit = asked.answer && asked.answer->contributions && *asked.answer->contributions;
    asked.light = lit ? lightFrom(**asked.answer->contributions) : nullptr;
}

const reference::Explanation* explanationOf(const Session& session) {
    const auto& answer = session.explaining.answer;
    return session.explaining.pixel && answer && answer->explanation && *answer->explanation
               ? &**answer->explanation
               : nullptr;
}

bool explainsThePicture(const Session& session) {
    const reference::Explanation* explanation = explanationOf(session);
    if (!explanation)
        return false;
    const reference::ProbeRequest& answered = session.explaining.answer->request;
    return answered.pixel == session.explaining.pixel &&
           answered.picture == pictureNow(session, explanation->width, explanation->height);
}

const reference::UnitExplanation* probedUnit(const Session& session) {
    const reference::Explanation* explanation = explanationOf(session);
    if (!explanation)
        return nullptr;
    for (std::size_t i = explanation->fragments.size(); i > 0; --i) {
        const reference::FragmentExplanation& fragment = explanation->fragments[i - 1];
        if (fragment.pass != session.selection.pass || fragment.outcome != reference::FragmentOutcome::Drawn)
            continue;
        const auto unit =
            std::ranges::find(fragment.units, session.selection.unit, &reference::UnitExplanation::unit);
        return unit == fragment.units.end() ? nullptr : &*unit;
    }
    return nullptr;
}

void chooseTexel(Session& session, const reference::TexelPlace& texel) {
    const reference::TexelQuestion question{session.selection.pass, session.selection.unit, texel};
    std::optional<reference::TexelQuestion>& chosen = session.explaining.texel;
    if (chosen == question)
        return clearTexel(session);
    chosen = question;
    session.explaining.texelOf = imageAsked(session);
}

void clearTexel(Session& session) {
    session.explaining.texel.reset();
    session.explaining.texelOf.reset();
}

void probeWithMouse(Session& session, const Panes& panes, bool hovered, bool clicked) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = hovered && ImGui::IsKeyDown('E') && !io.WantTextInput && !io.KeyCtrl;
    if (!held && !(clicked && session.explaining.isOpen))
        return;
    if (const auto pixel = panes.pixelAt(io.MousePos))
        session.explaining.pixel = {pixel->x, pixel->y};
    if (held && !session.explaining.isOpen)
        session.wantedTab = Tab::Explain;
}

void drawProbedPixel(Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Explaining& asked = session.explaining;
    if (asked.texel && asked.light && pictures.textureOf) {
        if (const unsigned light = pictures.textureOf(asked.light); light != 0)
            draw.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(light)),
                          {static_cast<float>(pane.frame.x), static_cast<float>(pane.frame.y)},
                          {static_cast<float>(pane.frame.right()), static_cast<float>(pane.frame.bottom())},
                          {panes.partLow().x, panes.partHigh().y}, {panes.partHigh().x, panes.partLow().y});
    }
    if (!asked.pixel)
        return;
    const auto corner = [&](int dx, int dy) {
        return panes.toWindow(pane, glm::vec2(static_cast<float>(asked.pixel->x + dx),
                                              static_cast<float>(asked.pixel->y + dy)));
    };
    const ImVec2 low = corner(0, 1); // the upper left
    const ImVec2 high = corner(1, 0);
    const ImVec2 middle((low.x + high.x) / 2, (low.y + high.y) / 2);
    const float em = ImGui::GetFontSize();
    const float half = std::max((high.x - low.x) / 2, em * 0.22F) + 1;
    for (const auto& [tint, width] :
         {std::pair(color::shade, em * 0.26F), std::pair(color::probed, em * 0.12F)}) {
        draw.AddRect({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, tint, 0, 0,
                     width);
        const float far = half + em * 0.55F;
        draw.AddLine({middle.x - far, middle.y}, {middle.x - half, middle.y}, tint, width);
        draw.AddLine({middle.x + half, middle.y}, {middle.x + far, middle.y}, tint, width);
        draw.AddLine({middle.x, middle.y - far}, {middle.x, middle.y - half}, tint, width);
        draw.AddLine({middle.x, middle.y + half}, {middle.x, middle.y + far}, tint, width);
    }
    if (session.probe)
        session.probe->items["probed pixel"] = {middle.x, middle.y, middle.x, middle.y, true};
}

} // namespace texplorer::ui
