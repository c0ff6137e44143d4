#include "app/ui/model/explaining.h"

#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"
#include "app/ui/model/shown_passes.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

/// White, as strong as the texel's share: the view gives it a colour.
std::shared_ptr<const Image> lightFrom(const reference::Contributions& found) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, found.width, found.height);
    std::ranges::fill(image.pixels, std::byte{255});
    const float most = found.weights.empty() ? 0 : std::max(0.0F, std::ranges::max(found.weights));
    for (std::size_t i = 0; i < found.weights.size(); ++i) {
        const float weight = found.weights[i];
        const float alpha = weight > 0 ? 0.25F + 0.65F * weight / most : 0;
        image.pixels[4 * i + 3] = static_cast<std::byte>(static_cast<int>(alpha * 255 + 0.5F));
    }
    return std::make_shared<const Image>(std::move(image));
}

reference::DrawRequest pictureNow(const Session& session, int width, int height) {
    Scene stepped;
    return {shownScene(session, stepped), session.document.images, session.look.playback.time, width, height,
            session.view.anisotropy,      session.view.rho};
}

/// The image in which the unit that is asked about would look up the texel now.
std::shared_ptr<const TextureImage> imageAsked(const Session& session) {
    const Scene& scene = presentScene(session);
    const reference::TexelQuestion& asked = *session.look.explaining.texel;
    const auto pass = static_cast<std::size_t>(asked.pass);
    if (pass >= scene.passes.size())
        return nullptr;
    const Texture* texture = textureOf(scene, scene.passes[pass].units[static_cast<std::size_t>(asked.unit)]);
    return texture ? session.document.images.find(*texture) : nullptr;
}

} // namespace

void askAboutPicture(Session& session, view::Size picture) {
    Explaining& asked = session.look.explaining;
    if (asked.texel && asked.texelOf != imageAsked(session))
        clearTexel(session);
    const auto [width, height] = picture;
    if ((!asked.pixel && !asked.texel) || width < 1 || height < 1) {
        asked.answer.reset();
        asked.light.reset();
        asked.lightOf.reset();
        session.services.probe->rest();
        return;
    }
    asked.answer =
        session.services.probe->answer({pictureNow(session, width, height), asked.pixel, asked.texel});
    if (asked.lightOf == asked.answer)
        return;
    asked.lightOf = asked.answer;
    const bool lit = asked.answer && asked.answer->contributions && *asked.answer->contributions;
    asked.light = lit ? lightFrom(**asked.answer->contributions) : nullptr;
}

const reference::Explanation* explanationOf(const Session& session) {
    const auto& answer = session.look.explaining.answer;
    return session.look.explaining.pixel && answer && answer->explanation && *answer->explanation
               ? &**answer->explanation
               : nullptr;
}

const reference::Explanation* pinnedExplanation(const Session& session) {
    const auto& pinned = session.look.explaining.pinned;
    return pinned ? &**pinned->explanation : nullptr;
}

void pinPixel(Session& session) {
    if (explanationOf(session))
        session.look.explaining.pinned = session.look.explaining.answer;
}

bool explainsThePicture(const Session& session) {
    const reference::Explanation* explanation = explanationOf(session);
    if (!explanation)
        return false;
    const reference::ProbeRequest& answered = session.look.explaining.answer->request;
    return answered.pixel == session.look.explaining.pixel &&
           answered.picture == pictureNow(session, explanation->width, explanation->height);
}

const reference::UnitExplanation* probedUnit(const Session& session) {
    const reference::Explanation* explanation = explanationOf(session);
    if (!explanation)
        return nullptr;
    for (std::size_t i = explanation->fragments.size(); i > 0; --i) {
        const reference::FragmentExplanation& fragment = explanation->fragments[i - 1];
        if (fragment.pass != session.look.selection.pass ||
            fragment.outcome != reference::FragmentOutcome::Drawn)
            continue;
        const auto unit =
            std::ranges::find(fragment.units, session.look.selection.unit, &reference::UnitExplanation::unit);
        return unit == fragment.units.end() ? nullptr : &*unit;
    }
    return nullptr;
}

void chooseTexel(Session& session, const reference::TexelPlace& texel) {
    const reference::TexelQuestion question{session.look.selection.pass, session.look.selection.unit, texel};
    std::optional<reference::TexelQuestion>& chosen = session.look.explaining.texel;
    if (chosen == question)
        return clearTexel(session);
    chosen = question;
    session.look.explaining.texelOf = imageAsked(session);
}

void clearTexel(Session& session) {
    session.look.explaining.texel.reset();
    session.look.explaining.texelOf.reset();
}

} // namespace texplorer::ui
