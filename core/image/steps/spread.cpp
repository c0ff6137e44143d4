#include "texplorer/image/linear_light.h"
#include "texplorer/image/steps/image_steps.h"

#include <algorithm>

namespace texplorer {
namespace {

/// One slice, in rings around the visible texels: all texels of a ring take their colours from the rings
/// before it, so that no order matters.
class Spreading {
public:
    Spreading(Image& image, int slice)
        : image_(image)
        , slice_(slice)
        , alpha_(static_cast<std::size_t>(alphaComponent(image.format)))
        , ring_(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), unseen) {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                if (image.at(x, y, slice)[alpha_] != std::byte{0})
                    ringAt(x, y) = 0;
    }

    void run() {
        std::vector<Place> ring = ringAround(visible(), 1);
        for (int number = 1; !ring.empty(); ++number) {
            for (const Place& place : ring)
                takeMean(place, number);
            ring = ringAround(ring, number + 1);
        }
    }

private:
    struct Place {
        int x;
        int y;
    };
    static constexpr int unseen = -1;

    int& ringAt(int x, int y) {
        return ring_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                     static_cast<std::size_t>(x)];
    }

    template<class Visit> ///< visit(x, y), of the up to eight texels around one
    void eachNeighbour(const Place& place, Visit visit) {
        for (int y = std::max(place.y - 1, 0); y <= std::min(place.y + 1, image_.height - 1); ++y)
            for (int x = std::max(place.x - 1, 0); x <= std::min(place.x + 1, image_.width - 1); ++x)
                if (x != place.x || y != place.y)
                    visit(x, y);
    }

    std::vector<Place> visible() {
        std::vector<Place> places;
        for (int y = 0; y < image_.height; ++y)
            for (int x = 0; x < image_.width; ++x)
                if (ringAt(x, y) == 0)
                    places.push_back({x, y});
        return places;
    }

    std::vector<Place> ringAround(const std::vector<Place>& inner, int number) {
        std::vector<Place> outer;
        for (const Place& place : inner)
            eachNeighbour(place, [&](int x, int y) {
                if (ringAt(x, y) != unseen)
                    return;
                ringAt(x, y) = number;
                outer.push_back({x, y});
            });
        return outer;
    }

    void takeMean(const Place& place, int number) {
        std::array<int, 3> sums{};
        int count = 0;
        eachNeighbour(place, [&](int x, int y) {
            if (ringAt(x, y) == unseen || ringAt(x, y) >= number)
                return;
            ++count;
            for (std::size_t i = 0; i < alpha_; ++i) // alpha is the last component
                sums[i] += std::to_integer<int>(image_.at(x, y, slice_)[i]);
        });
        for (std::size_t i = 0; i < alpha_; ++i)
            image_.at(place.x, place.y, slice_)[i] = static_cast<std::byte>((sums[i] + count / 2) / count);
    }

    Image& image_;
    int slice_;
    std::size_t alpha_;
    std::vector<int> ring_; ///< 0: visible
};

} // namespace

Image withColorsSpread(Image image) {
    if (alphaComponent(image.format) < 1) // no alpha, or nothing else
        return image;
    for (int slice = 0; slice < image.depth; ++slice)
        Spreading(image, slice).run();
    return image;
}

} // namespace texplorer
