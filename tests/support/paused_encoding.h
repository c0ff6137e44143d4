#pragma once

#include "texplorer/texture/texture_levels.h"

#include <latch>
#include <utility>
#include <vector>

namespace texplorer::test {

/// The compressing of textures at run time. The first time it is held up, so that a test knows that it is
/// under way; `shares` says how far each came.
class PausedEncoding {
public:
    /// Held up once `share` is done. Where that is more than the first level, a second time is never taken
    /// for the first: it begins below.
    explicit PausedEncoding(float share = 0.99F)
        : share_(share) {}

    /// Without a cache.
    [[nodiscard]] LevelWork work() {
        return {{},
                [this](float done) {
                    if (shares.empty() || done < shares.back())
                        shares.push_back(0);
                    shares.back() = done;
                    if (done < share_ || !std::exchange(isFirst_, false))
                        return;
                    begun_.count_down();
                    goOn_.wait();
                },
                {}};
    }
    void waitUntilBegun() const { begun_.wait(); }
    void goOn() { goOn_.count_down(); }

    std::vector<float> shares; ///< of the working thread, until it is waited for

private:
    float share_;
    bool isFirst_ = true;
    std::latch begun_{1};
    std::latch goOn_{1};
};

} // namespace texplorer::test
