try {
    if (!gl) throw new Error("This page needs WebGL 2, which the browser doesn't offer.");
    init();
    resize();
    new ResizeObserver(resize).observe(canvas);
    requestAnimationFrame(frame);
} catch (error) {
    canvas.style.display = "none";
    const problem = document.getElementById("problem");
    problem.textContent = error.message;
    problem.hidden = false;
}
