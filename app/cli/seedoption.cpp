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
    bool isNumber = false;
    const qulonglong seed = line.value(seedOption).toULongLong(&isNumber);
    if (!isNumber)
        return InputError{QStringLiteral("--seed"),
                          QStringLiteral("“%1” is no whole number").arg(line.value(seedOption)),
                          QStringLiteral("0 or more")};
    return std::uint64_t(seed);
}

} // namespace pixelplumb::cli
