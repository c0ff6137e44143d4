#include "app/animation/make_encoder.h"

#include "app/animation/gif_encoder.h"
#include "app/animation/webp_encoder.h"
#include "texplorer/animation/apng.h"

#include <algorithm>
#include <new>

namespace texplorer::animation {

Result<std::unique_ptr<Encoder>> makeEncoder(Format format, const Settings& settings) {
    const FormatRow& row = rowOf(format);
    if (std::max(settings.width, settings.height) > row.maxExtent)
        return fail(ErrorCode::TooLarge,
                    Sentence("a {0} has at most {1} × {2} pixels, found {3} × {4}", row.name, row.maxExtent,
                             row.maxExtent, settings.width, settings.height));
    try {
        switch (format) {
        case Format::Gif:
            return gifEncoder(settings);
        case Format::WebP:
            return webpEncoder(settings);
        case Format::Apng:
            break;
        }
        return apngEncoder(settings);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for an animation of this size");
    }
}

} // namespace texplorer::animation
