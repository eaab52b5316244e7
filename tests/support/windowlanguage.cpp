// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/numberformat.h"
#include "widgets/look/translation.h"

#include <QCoreApplication>

#include <memory>

namespace {

/// Every test of the window sees it as a person does whose language is English, with plural forms,
/// whatever the machine's language is.
void speakEnglish()
{
    static std::unique_ptr<pixelplumb::Translation> english;
    english = std::make_unique<pixelplumb::Translation>(QStringList(QStringLiteral("en")));
    qAddPostRoutine([] { english.reset(); });
    pixelplumb::keepDecimalPoint();
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(speakEnglish)
