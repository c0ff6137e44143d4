#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/noise.h"
#include "texplorer/image/patterns/patterns.h"

#include <algorithm>
#include <cmath>

namespace texplorer {

namespace {

constexpr int treeSize = 256;

struct Branch {
    float fromX, fromY, fromWidth;
    float toX, toY, toWidth;
};

// The wood: a trunk that spreads at the roots, and boughs up into the crown.
constexpr Branch branches[] = {
    {128, 0, 40, 128, 16, 22},  {128, 14, 23, 126, 70, 18}, {126, 68, 18, 130, 130, 12},
    {127, 62, 11, 84, 112, 6},  {127, 78, 10, 172, 124, 6}, {129, 110, 9, 104, 170, 4},
    {130, 118, 9, 158, 178, 4}, {96, 98, 6, 62, 108, 3},    {160, 112, 6, 196, 116, 3},
};

struct Clump {
    float x, y, radius;
};

// The crown: clumps of foliage, drawn from the back to the front.
constexpr Clump clumps[] = {
    {128, 200, 44}, {86, 186, 40},  {170, 188, 40}, {58, 150, 36},  {198, 152, 36}, {128, 160, 48},
    {92, 142, 36},  {166, 144, 36}, {52, 122, 26},  {204, 124, 26}, {112, 182, 34}, {146, 206, 30},
    {74, 118, 26},  {180, 116, 26}, {128, 130, 34}, {100, 204, 28},
};

void drawBranch(Canvas& canvas, const Branch& branch) {
    const float dx = branch.toX - branch.fromX;
    const float dy = branch.toY - branch.fromY;
    const float length = std::sqrt(dx * dx + dy * dy);
    const int top = static_cast<int>(std::max(branch.fromY, branch.toY)) + 8;
    for (int y = std::max(0, static_cast<int>(std::min(branch.fromY, branch.toY)) - 8); y <= top; ++y)
        for (int x = 0; x < treeSize; ++x) {
            const float px = static_cast<float>(x) + 0.5F - branch.fromX;
            const float py = static_cast<float>(y) + 0.5F - branch.fromY;
            const float along = std::clamp((px * dx + py * dy) / (length * length), 0.0F, 1.0F);
            const float half = (branch.fromWidth + (branch.toWidth - branch.fromWidth) * along) / 2;
            const float offX = px - along * dx;
            const float offY = py - along * dy;
            const float away = std::sqrt(offX * offX + offY * offY);
            if (away >= half + 0.5F)
                continue;
            const float side = offX / half; // -1 on the lit left, 1 in the shadow
            const float bark = tiledNoise(static_cast<float>(x) / 3, static_cast<float>(y) / 14, 0, 256, 5);
            const Color wood =
                mix({142, 106, 72, 255}, {58, 40, 28, 255}, 0.45F + 0.4F * side + 0.5F * (bark - 0.5F));
            canvas.blend(x, y, wood, half + 0.5F - away);
        }
}

// One leaf: a small ellipse, turned at random.
void drawLeaf(Canvas& canvas, float x, float y, float size2, float turnX, float turnY, Color color) {
    const int reach = static_cast<int>(size2) + 2;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const int column = static_cast<int>(x) + i;
            const int row = static_cast<int>(y) + j;
            const float px = static_cast<float>(column) + 0.5F - x;
            const float py = static_cast<float>(row) + 0.5F - y;
            const float along = (px * turnX + py * turnY) / size2;
            const float across = 1.9F * (py * turnX - px * turnY) / size2;
            const float distance = std::sqrt(along * along + across * across);
            if (distance < 1.2F)
                canvas.blend(column, row, color, (1.2F - distance) * 3);
        }
}

void drawClump(Canvas& canvas, const Clump& clump, int number) {
    // Dark leaves first, light ones on top and towards the upper left, where the sun is.
    constexpr int leaves = 260;
    for (int leaf = 0; leaf < leaves; ++leaf) {
        const auto random = [&](std::uint32_t seed) { return hash01(number, leaf, 0, seed); };
        const float layer = static_cast<float>(leaf) / leaves;
        float dx = 2 * random(1) - 1;
        float dy = 2 * random(2) - 1;
        if (dx * dx + dy * dy > 1)
            continue;
        dx = dx * (1 - 0.25F * layer) - 0.16F * layer;
        dy = dy * (1 - 0.25F * layer) + 0.20F * layer;
        const float sun =
            std::clamp(0.40F + 0.34F * (dy - dx) + 0.34F * layer + 0.25F * (random(3) - 0.5F), 0.0F, 1.0F);
        const Color dark = mix({24, 58, 24, 255}, {66, 122, 40, 255}, std::min(1.0F, sun * 2));
        const Color color = mix(dark, {168, 204, 84, 255}, std::max(0.0F, sun * 2 - 1));
        const float turnX = 2 * random(4) - 1;
        const float turnY = 2 * random(5) - 1;
        const float length = std::max(0.05F, std::sqrt(turnX * turnX + turnY * turnY));
        drawLeaf(canvas, clump.x + dx * clump.radius, clump.y + dy * clump.radius, 3.2F + 2.4F * random(6),
                 turnX / length, turnY / length, color);
    }
}

} // namespace

Image drawTree() {
    // What is transparent is green or brown all the same: a linear filter blends it into the outline.
    Canvas canvas(treeSize, treeSize);
    canvas.fill(0, 0, treeSize, 72, {92, 66, 44, 0});
    canvas.fill(0, 72, treeSize, treeSize - 72, {58, 104, 40, 0});
    for (const Branch& branch : branches)
        drawBranch(canvas, branch);
    int number = 0;
    for (const Clump& clump : clumps)
        drawClump(canvas, clump, number++);
    return std::move(canvas).take();
}

} // namespace texplorer
