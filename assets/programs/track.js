// What a component's keys say at a time: between two of them a mixture, before the first what that says, after
// the last what that says.
function track(keys, seconds, component) {
    const time = (key) => Math.fround(key.seconds); // floats, as OpenGL has them
    const value = (key) => Math.fround(key.value[component]);
    const next = keys.findIndex((key) => time(key) > seconds);
    if (next <= 0) return value(keys[next === 0 ? 0 : keys.length - 1]);
    const from = keys[next - 1], to = keys[next];
    const share = from.easing((seconds - time(from)) / (time(to) - time(from)));
    return value(from) * (1 - share) + value(to) * share;
}
