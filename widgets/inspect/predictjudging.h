// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/prediction.h"

namespace pixelplumb {

/// The verdict on an answer in Predict, with the reason when it is right.
QString verdictText(const Prediction &prediction, Guess guess);

} // namespace pixelplumb
