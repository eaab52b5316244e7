// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"

#include <QApplication>

using namespace Qt::StringLiterals;

/// main() of the programs that test the window. They see it as an English-speaking user does, with
/// plural forms, on a screen of 96 dots per inch, whatever the machine has.
int main(int argc, char **argv)
{
    const QApplication application(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const pixelplumb::Translation english(QStringList(u"en"_s));
    pixelplumb::keepDecimalPoint();
    return pixelplumb::runTests(QCoreApplication::arguments());
}
