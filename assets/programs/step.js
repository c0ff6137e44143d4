// Nothing lies between two names or switches: each holds until the next one comes.
function step(steps, seconds) {
    let i = 0;
    while (i + 1 < steps.length && Math.fround(steps[i + 1].seconds) <= seconds) ++i;
    return steps[i].value;
}
