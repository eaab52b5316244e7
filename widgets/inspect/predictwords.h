// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/prediction.h"

namespace pixelplumb {

/// What is told of an answer to a question of Predict, the reason when it is right.
QString verdictText(const Prediction &prediction, Guess guess);

} // namespace pixelplumb
