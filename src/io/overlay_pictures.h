// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"
#include "io/stage_pictures.h"

namespace tessera
{

/// Draws the stages of an overlay, like the paper's Figs. 3, 4 and 7, as .svg and .png into a
/// folder: 1-rectangle (Fig. 4a), 2-points (4b), 3-before-recovery, 4-recovered (4c), 0-loops (the
/// operands' loops, Fig. 3) and 5-colors (4d): with two operands the sets of Algorithm 2 in one
/// picture and 5-theta-o, -t, -s one by one, otherwise the parts of the result.
class OverlayPictures: public StagePictures
{
public:
    using StagePictures::StagePictures;

    /// After the run. Throws Error(Unwritable).
    void colored(const OverlayResult& result);

private:
    void drawLoops(const OverlayResult& result);
    void drawTheta(const OverlayResult& result);
    void drawParts(const OverlayResult& result);
};

} // namespace tessera
