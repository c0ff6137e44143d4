#pragma once

#include "tests/random/window_trial.h"

#include <random>

namespace texplorer::random {

/// A window that gets random input. Fails like a test.
class MonkeyTrial : public WindowTrial {
public:
    MonkeyTrial(unsigned seed, int number, Journal& journal);
    void run();

private:
    void act();
    void look();
    [[nodiscard]] int below(int end);
    [[nodiscard]] ImVec2 somewhere();

    std::mt19937 random_;
    int width_ = 0;
    int height_ = 0;
    Scene initial_;
    int action_ = 0;
};

} // namespace texplorer::random
