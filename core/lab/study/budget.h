// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

namespace pixelplumb {

/// What a user can afford: errors, or time.
enum class Budget : std::uint8_t {
    Exact, ///< the truth, byte for byte
    OneLevel, ///< the truth's coverage, and bytes that are off by at most one
    TenPerMillion, ///< at most 10 wrong pixels per million
    SixteenMilliseconds, ///< a frame of 60 a second
};
inline constexpr std::array allBudgets
    = {Budget::Exact, Budget::OneLevel, Budget::TenPerMillion, Budget::SixteenMilliseconds};
/// "exact", "1-level", "10-ppm", "16-ms"
std::string_view nameOf(Budget budget);
std::optional<Budget> budgetNamed(std::string_view name);
/// "at most one level"
QString textOf(Budget budget);

enum class BudgetGround : std::uint8_t { Proof, Measurement, Nobody };

/// The contender that meets the budget in the least time; among those that draw within 16 ms, the
/// one with the fewest wrong pixels, then the least time.
struct BudgetAnswer {
    Budget budget = Budget::Exact;
    BudgetGround ground = BudgetGround::Nobody;
    QString contender; ///< id; empty if none meets it
    double nanosecondsPerPixel = 0; ///< 0 if it was not timed
    QString reason; ///< a sentence: what meets it, by what, at what cost
};

/// Whether the figures of a row meet a budget of errors.
bool meets(Budget budget, const AccuracyFigures &figures);

BudgetAnswer cheapestFor(Budget budget, const Study &study, const QString &family);

} // namespace pixelplumb
