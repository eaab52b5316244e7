// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"

#include <QCoreApplication>

/// main() of the programs that test core, which needs no window.
int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    return pixelplumb::runTests(QCoreApplication::arguments());
}
