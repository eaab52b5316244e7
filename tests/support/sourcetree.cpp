// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sourcetree.h"

namespace pixelplumb {

QString resource(const QString &path) { return QStringLiteral(PIXELPLUMB_RESOURCES) + path; }

QString testData(const QString &name) { return resource(QStringLiteral("/../tests/data/")) + name; }

} // namespace pixelplumb
