#include "texplorer/reference/light_depth.h"

#include "texplorer/image/depth_pixels.h"
#include "texplorer/reference/raster/assembly.h"
#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/raster/shade.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

namespace texplorer::reference {

namespace {

static_assert(farthestDepth == (1U << lightDepthBits) - 1);

/// Those that any pass draws, each once.
std::vector<std::size_t> seenModels(const Scene& scene) {
    std::vector<std::size_t> models;
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        if (isDrawn(scene, m))
            models.push_back(m);
    }
    return models;
}

/// The nearest depth of every texel.
class DepthPicture {
public:
    DepthPicture(int size, std::stop_token stop)
        : size_(size)
        , stop_(std::move(stop))
        , depths_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), farthestDepth) {}

    void draw(const Model& model, const glm::dmat4& modelView, const LightView& light) {
        const Pass pass;
        PassState state;
        state.pass = &pass;
        const std::function<void(const Triangle&)> fill = [this](const Triangle& each) { draw(each); };
        const Assembly assembly(state, model, {size_, size_}, fill);
        const Mesh mesh = meshOf(model);
        const glm::mat4 toClip(light.projection * light.view * modelView);
        std::vector<ShadedVertex> corners;
        eachPart(mesh, [&](std::span<const std::uint32_t> part, std::size_t) {
            if (stop_.stop_requested())
                return;
            corners.clear();
            for (const std::uint32_t vertex : part)
                corners.push_back({.clip = toClip * glm::vec4(mesh.vertices[vertex].position, 1)});
            assembly.add(corners);
        });
    }

    [[nodiscard]] Image image() const {
        Image image = Image::uninitialised(PixelFormat::Depth32, size_, size_);
        for (std::size_t i = 0; i < depths_.size(); ++i)
            storeDepth(widenedDepth(depths_[i], lightDepthBits),
                       image.pixels.data() + i * sizeof(std::uint32_t));
        return image;
    }

private:
    void draw(const Triangle& triangle) {
        eachCoveredRow(triangle, {0, size_ - 1, 0, size_ - 1}, [&](int x, int y, int count) {
            std::uint32_t* const row =
                depths_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
            for (const int end = x + count; x < end; ++x)
                row[x] = std::min(row[x], fragmentDepth(triangle, glm::vec2(x, y) - triangle.origin));
        });
    }

    int size_;
    std::stop_token stop_;
    std::vector<std::uint32_t> depths_;
};

template<class Visit> ///< visit(texture), of units that are on
void forEachLightDepth(const Scene& scene, Visit visit) {
    for (const Pass& pass : scene.passes) {
        for (const Unit& unit : pass.units) {
            const auto texture = static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
            if (pass.enabled && unit.enabled && texture < scene.textures.size() &&
                scene.textures[texture].source == SourceKind::LightDepth)
                visit(scene.textures[texture]);
        }
    }
}

} // namespace

Image drawLightDepths(const Scene& scene, double time, int size, const std::stop_token& stop) {
    const LightView light = lightView(scene.light);
    DepthPicture picture(std::max(size, 1), stop);
    for (const std::size_t index : seenModels(scene)) {
        const Model& model = scene.models[index];
        picture.draw(model, glm::dmat4(modelViewMatrix(scene.view, model, time)), light);
    }
    return picture.image();
}

bool showsLightDepths(const Scene& scene) {
    bool any = false;
    forEachLightDepth(scene, [&any](const Texture&) { any = true; });
    return any;
}

LightDepths::Seen::Seen(const Scene& scene, double when)
    : view(scene.view)
    , light(scene.light)
    , time(when) {
    for (const std::size_t model : seenModels(scene))
        models.push_back(scene.models[model]);
    turns = std::ranges::any_of(models, [](const Model& model) { return model.spin != glm::vec3(0); });
}

bool LightDepths::Seen::holds(const Scene& scene, double when) const {
    return view == scene.view && light == scene.light && (!turns || time == when) &&
           std::ranges::equal(models, seenModels(scene), {}, {},
                              [&scene](std::size_t model) -> const Model& { return scene.models[model]; });
}

ImageSource LightDepths::addedTo(const ImageSource& images, const Scene& scene, double time,
                                 const std::stop_token& stop) {
    std::set<int> sizes;
    forEachLightDepth(scene, [&](const Texture& texture) {
        if (!images.holdsLightDepth(texture.depthSize))
            sizes.insert(texture.depthSize);
    });
    if (sizes.empty()) {
        *this = {};
        return images;
    }
    if (!seen_ || !seen_->holds(scene, time)) {
        seen_.emplace(scene, time);
        pictures_.clear();
    }
    std::erase_if(pictures_, [&](const auto& entry) { return !sizes.contains(entry.first); });
    ImageSource all = images;
    for (const int size : sizes) {
        if (!pictures_.contains(size)) {
            Image depths = drawLightDepths(scene, time, size, stop);
            if (stop.stop_requested())
                return all;
            pictures_[size] = drawnImage(std::move(depths));
        }
        all.putLightDepth(size, pictures_.at(size));
    }
    return all;
}

} // namespace texplorer::reference
