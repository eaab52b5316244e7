// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/seedoption.h"

namespace pixelplumb::cli {

namespace {

const QString seedOption = QStringLiteral("seed");

} // namespace

void addSeedOption(CommandLine &line, const QString &what)
{
    line.addOption({seedOption, QStringLiteral("Of the random %1; 1 if left out.").arg(what),
                    QStringLiteral("number"), QStringLiteral("1")});
}

Result<std::uint64_t> chosenSeed(const CommandLine &line)
{
    const QString word = line.value(seedOption);
    bool isNumber = false;
    const qulonglong seed = word.toULongLong(&isNumber);
    if (!isNumber)
        return InputError{QStringLiteral("--seed"),
                          QStringLiteral("“%1” is no whole number of 64 bits").arg(word),
                          QStringLiteral("0 … 18446744073709551615")};
    return std::uint64_t(seed);
}

} // namespace pixelplumb::cli
