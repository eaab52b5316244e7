// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/edgewalktraces.h"

namespace pixelplumb {

template DrawFunction drawWith<VariedColumnScan>;
template DrawFunction drawWith<VariedRowWalk>;

} // namespace pixelplumb
