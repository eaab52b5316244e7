// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/toleranceoption.h"

#include "app/cli/suggestion.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <array>

namespace pixelplumb::cli {

namespace {

const QString toleranceOption = QStringLiteral("tolerance");
constexpr std::array tolerances = {Arithmetic::Float32, Arithmetic::Float64, Arithmetic::Exact};

} // namespace

void addToleranceOption(CommandLine &line)
{
    line.addOption(
        {toleranceOption,
         QStringLiteral("The arithmetic that a right program may compute in; its rounding is "
                        "allowed for: float32, float64 or exact; float32 if left out."),
         QStringLiteral("name"), QStringLiteral("float32")});
}

Result<Arithmetic> chosenTolerance(const CommandLine &line)
{
    const QString word = line.value(toleranceOption);
    const auto arithmetic = arithmeticNamed(word.toStdString());
    if (arithmetic && std::ranges::find(tolerances, *arithmetic) != tolerances.end())
        return *arithmetic;
    return unknownName(QStringLiteral("--") + toleranceOption, QStringLiteral("name"), word,
                       namesOf(tolerances));
}

} // namespace pixelplumb::cli
