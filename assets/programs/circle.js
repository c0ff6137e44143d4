// Sine and cosine of an angle in quarter turns. Those of whole ones are exact, so that poles are points and seams have no gap.
function circle(quarters) {
    const exact = [0, 1, 0, -1, 0, 1];
    const rest = quarters - 4 * Math.floor(quarters / 4);
    if (Number.isInteger(rest)) return [exact[rest], exact[rest + 1]];
    return [Math.sin((rest * Math.PI) / 2), Math.cos((rest * Math.PI) / 2)];
}
