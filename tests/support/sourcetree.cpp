// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sourcetree.h"

namespace pixelplumb {

QString resource(const QString &path) { return QStringLiteral(PIXELPLUMB_RESOURCES) + path; }

} // namespace pixelplumb
