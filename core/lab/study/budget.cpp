// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/budget.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double frameNanoseconds = 16e6;
constexpr double affordedPerMillion = 10;

/// A row with figures.
struct Offer {
    const StudyContender *contender = nullptr;
    const LabRow *row = nullptr;
    std::optional<double> perPixel; ///< none: there was no time to measure it

    /// Whether everything is proved.
    bool isProved() const { return contender->isProved; }
};

std::vector<Offer> offersOf(const Study &study, const QString &family)
{
    std::vector<Offer> offers;
    for (const StudyContender &contender : study.contenders) {
        const LabRow *row = study.row(contender.id, family);
        // Another renderer cannot be chosen here.
        if (!row || !row->accuracy || contender.kernel == LabKernel::Peer)
            continue;
        offers.push_back({&contender, row, study.perPixel(*row)});
    }
    return offers;
}

QString costText(const Offer &offer)
{
    return offer.perPixel ? u"%1 ns a pixel"_s.arg(*offer.perPixel, 0, 'f', 2) : u"not timed"_s;
}

/// Those that were not timed come last, in their order.
bool isCheaper(const Offer &one, const Offer &other)
{
    return one.perPixel && (!other.perPixel || *one.perPixel < *other.perPixel);
}

QString observation(const Offer &offer)
{
    const AccuracyFigures &figures = *offer.row->accuracy;
    return u"measured: %1 wrong of %2 pixels, bytes off by %3 at most"_s.arg(figures.wrongPixels())
        .arg(figures.pixels)
        .arg(figures.largestByteError);
}

BudgetAnswer answerFor(Budget budget, const Offer &offer)
{
    BudgetAnswer answer;
    answer.budget = budget;
    // A time is never proved.
    const bool isProved = offer.isProved() && budget != Budget::SixteenMilliseconds;
    answer.ground = isProved ? BudgetGround::Proof : BudgetGround::Measurement;
    answer.contender = offer.contender->id;
    answer.nanosecondsPerPixel = offer.perPixel.value_or(0);
    answer.reason = u"%1, %2; %3"_s.arg(
        offer.contender->label, costText(offer),
        offer.isProved() ? u"proved for "_s + offer.contender->domain : observation(offer));
    return answer;
}

} // namespace

std::string_view nameOf(Budget budget)
{
    switch (budget) {
    case Budget::Exact:
        return "exact";
    case Budget::OneLevel:
        return "1-level";
    case Budget::TenPerMillion:
        return "10-ppm";
    case Budget::SixteenMilliseconds:
        return "16-ms";
    }
    return {};
}

std::optional<Budget> budgetNamed(std::string_view name)
{
    for (const Budget budget : allBudgets) {
        if (nameOf(budget) == name)
            return budget;
    }
    return std::nullopt;
}

QString textOf(Budget budget)
{
    switch (budget) {
    case Budget::Exact:
        return u"exact"_s;
    case Budget::OneLevel:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "at most one level"));
    case Budget::TenPerMillion:
        return u"at most 10 wrong pixels per million"_s;
    case Budget::SixteenMilliseconds:
        return u"16 ms a frame"_s;
    }
    return {};
}

bool meets(Budget budget, const AccuracyFigures &figures)
{
    switch (budget) {
    case Budget::Exact:
        return figures.wrongPixels() == 0;
    case Budget::OneLevel:
        return figures.wrongCoverage() == 0 && figures.largestByteError <= 1;
    case Budget::TenPerMillion:
        return figures.wrongPerMillion() <= affordedPerMillion;
    case Budget::SixteenMilliseconds:
        return true;
    }
    return false;
}

BudgetAnswer cheapestFor(Budget budget, const Study &study, const QString &family)
{
    std::vector<Offer> offers = offersOf(study, family);
    const StudyFamily *drawn = study.family(family);
    if (budget == Budget::SixteenMilliseconds) {
        // The timed part takes this long; the whole takes time in proportion.
        std::erase_if(offers, [&](const Offer &offer) {
            if (!offer.perPixel)
                return true;
            const double whole = offer.row->cost->perDraw.median * double(drawn->triangles)
                / double(drawn->timedTriangles);
            return whole > frameNanoseconds;
        });
        std::ranges::stable_sort(offers, [](const Offer &a, const Offer &b) {
            const std::int64_t wrongA = a.row->accuracy->wrongPixels();
            const std::int64_t wrongB = b.row->accuracy->wrongPixels();
            if (wrongA != wrongB)
                return wrongA < wrongB;
            return isCheaper(a, b);
        });
    } else {
        std::erase_if(offers,
                      [&](const Offer &offer) { return !meets(budget, *offer.row->accuracy); });
        std::ranges::stable_sort(offers, isCheaper);
        // Finding nothing wrong is not exactness; if there is a proof, only that counts.
        if (budget == Budget::Exact) {
            std::ranges::stable_sort(offers, [](const Offer &a, const Offer &b) {
                return a.isProved() && !b.isProved();
            });
        }
    }
    if (!offers.empty())
        return answerFor(budget, offers.front());
    BudgetAnswer nobody;
    nobody.budget = budget;
    nobody.reason = u"no contender meets “%1”"_s.arg(textOf(budget));
    return nobody;
}

} // namespace pixelplumb
