// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/methods/shading/plannedmethod.h"
#include "core/methods/walks/edgewalkkernels.h"

#include <cstdlib>
#include <cstring>

using namespace pixelplumb;

/// flatscene planned|plain: draws a scene that needs nothing beyond colour, either through the
/// method, which first checks which effects it needs, or by the kernel without effects. The test
/// counts the instructions of both.
int main(int argc, char **argv)
{
    if (argc != 2)
        return EXIT_FAILURE;
    FrameSpec spec;
    spec.width = 509;
    spec.height = 503;
    const FrameBuffer frame(spec);
    Primitives primitives;
    for (std::int64_t i = 0; i < 40; ++i)
        primitives.triangles.push_back({{{{latticePixel(3 + i, 5), {{255, 0, 0}}},
                                          {latticePixel(497, 11 + 7 * i), {{0, 255, 0}}},
                                          {latticePixel(101 + i, 499), {{0, 0, 255}}}}}});
    for (int repeat = 0; repeat < 5; ++repeat) {
        const Run run(nullptr, primitives, {}, frame.view());
        if (std::strcmp(argv[1], "planned") == 0)
            drawPlanned<ShadedMethod::ColumnScan, drawWith<ColumnScanKernel>>(run, frame.view(),
                                                                              {});
        else
            drawWith<ColumnScanKernel>(run, frame.view(), {});
    }
    return EXIT_SUCCESS;
}
