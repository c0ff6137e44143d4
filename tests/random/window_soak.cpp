#include "tests/random/window_soak.h"

#include "tests/random/layout_trial.h"
#include "tests/random/monkey_trial.h"

namespace texplorer::random {

namespace {

template<class Trial>
Subject subjectOf(std::string one, std::string many, std::string command, unsigned seed) {
    Subject subject;
    subject.one = std::move(one);
    subject.many = std::move(many);
    subject.arguments = std::move(command) + " --seed " + std::to_string(seed);
    subject.batch = 10;
    subject.open = [seed](int) -> Work {
        return [seed](int number, Journal& journal) { Trial(seed, number, journal).run(); };
    };
    return subject;
}

} // namespace

Subject randomHands(unsigned seed) {
    return subjectOf<MonkeyTrial>("monkey", "monkeys at a window", "window", seed);
}

Subject layouts(unsigned seed) {
    return subjectOf<LayoutTrial>("layout", "layouts", "layouts", seed);
}

int layoutCount() {
    return LayoutTrial::count();
}

} // namespace texplorer::random
