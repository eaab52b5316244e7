// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labcomparison.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const QString ownSceneId = QStringLiteral("own-scene");

std::optional<Spread> perPixelOf(const Study &study, const LabRow *row)
{
    if (!row || !study.perPixel(*row))
        return std::nullopt;
    return scaled(row->cost->perDraw, 1 / double(study.family(row->family)->timedPixels));
}

std::optional<double> wrongOf(const LabRow *row)
{
    if (!row || !row->accuracy)
        return std::nullopt;
    return row->accuracy->wrongPerMillion();
}

bool isMeasured(const LabRow *row) { return row && row->outcome == LabOutcome::Measured; }

LabChange changeBetween(const Spread &before, const Spread &after)
{
    if (after.lower > before.upper)
        return LabChange::Slower;
    if (after.upper < before.lower)
        return LabChange::Faster;
    return LabChange::WithinSpread;
}

/// Whether both studies drew the same triangles of a family, as far as they tell: others take other
/// times.
bool isSameFamily(const Study &before, const Study &after, const QString &id)
{
    const StudyFamily *old = before.family(id);
    const StudyFamily *fresh = after.family(id);
    if (!old || !fresh)
        return !old && !fresh;
    if (old->digest && fresh->digest)
        return old->digest == fresh->digest;
    return before.seed == after.seed && before.extent == after.extent
        && old->triangles == fresh->triangles && old->timedPixels == fresh->timedPixels;
}

/// Rows of other triangles, and rows under other settings, tell nothing of a change.
bool isSameWork(const Study &before, const Study &after, const LabRow *old, const LabRow *fresh)
{
    return old && fresh && old->settings == fresh->settings
        && isSameFamily(before, after, old->family);
}

QStringList settingsChanged(const Study &before, const Study &after)
{
    QStringList changed;
    for (const LabRow &row : before.rows) {
        const LabRow *const fresh = after.row(row.contender, row.family);
        if (isMeasured(&row) && isMeasured(fresh) && row.settings != fresh->settings)
            changed << row.contender + QStringLiteral(" on ") + row.family;
    }
    return changed;
}

QString textOf(const StudyFamily *scene)
{
    if (!scene)
        return QStringLiteral("none");
    return QStringLiteral("%1 triangles, %2 px of %3 triangles timed")
        .arg(scene->triangles)
        .arg(scene->timedPixels)
        .arg(scene->timedTriangles);
}

QString orNone(const QString &text) { return text.isEmpty() ? QStringLiteral("none") : text; }

LabRowComparison comparisonOf(const Study &before, const Study &after, const LabRow &row)
{
    const LabRow *old = before.row(row.contender, row.family);
    const LabRow *fresh = after.row(row.contender, row.family);
    LabRowComparison result;
    result.contender = row.contender;
    result.family = row.family;
    result.before = perPixelOf(before, old);
    result.after = perPixelOf(after, fresh);
    const bool isSame = isSameWork(before, after, old, fresh);
    result.isSamePictures = isSame && before.seed == after.seed && before.extent == after.extent;
    result.isMissing = isMeasured(old) && !isMeasured(fresh);
    if (result.before && result.after && isSame) {
        result.timesBefore = result.after->median / result.before->median;
        result.change = changeBetween(*result.before, *result.after);
    }
    result.wrongBefore = wrongOf(old);
    result.wrongAfter = wrongOf(fresh);
    return result;
}

QString number(const std::optional<double> &value, int digits)
{
    return value ? QString::number(*value, 'f', digits) : QStringLiteral("–");
}

QString median(const std::optional<Spread> &spread)
{
    return number(spread ? std::optional(spread->median) : std::nullopt, 3);
}

} // namespace

QString nameOf(LabChange change)
{
    switch (change) {
    case LabChange::WithinSpread:
        return QStringLiteral("within spread");
    case LabChange::Faster:
        return QStringLiteral("faster");
    case LabChange::Slower:
        return QStringLiteral("slower");
    case LabChange::NotComparable:
        return QStringLiteral("not comparable");
    }
    return {};
}

std::int64_t LabComparison::count(LabChange change) const
{
    return std::ranges::count(rows, change, &LabRowComparison::change);
}

std::int64_t LabComparison::countLessAccurate() const
{
    return std::ranges::count_if(rows, &LabRowComparison::isLessAccurate);
}

std::int64_t LabComparison::countMissing() const
{
    return std::ranges::count(rows, true, &LabRowComparison::isMissing);
}

bool LabComparison::isWorse() const
{
    return count(LabChange::Slower) + countLessAccurate() + countMissing() > 0;
}

LabComparison compareStudies(const Study &before, const Study &after)
{
    LabComparison comparison;
    for (const LabRow &row : before.rows)
        comparison.rows.push_back(comparisonOf(before, after, row));
    for (const LabRow &row : after.rows) {
        if (!before.row(row.contender, row.family))
            comparison.rows.push_back(comparisonOf(before, after, row));
    }
    const auto remark =
        [&](const QString &what, const QString &was, const QString &is) {
            if (was != is)
                comparison.remarks
                    << QStringLiteral("%1: %2 before, %3 after").arg(what, orNone(was), orNone(is));
        };
    const MachineConditions &was = before.conditions, &is = after.conditions;
    remark(QStringLiteral("machine"), was.processor, is.processor);
    remark(QStringLiteral("compiler"), was.compiler, is.compiler);
    remark(QStringLiteral("flags"), was.flags, is.flags);
    remark(QStringLiteral("build type"), was.buildType, is.buildType);
    remark(QStringLiteral("sanitizers"), was.sanitizers.join(QStringLiteral(", ")),
           is.sanitizers.join(QStringLiteral(", ")));
    remark(QStringLiteral("instruction set"), was.instructionSet, is.instructionSet);
    remark(QStringLiteral("seed"), QString::number(before.seed), QString::number(after.seed));
    remark(QStringLiteral("extent"), nameOf(before.extent), nameOf(after.extent));
    const auto completeness = [](const Study &study) {
        return study.isComplete ? QStringLiteral("complete") : QStringLiteral("ended early");
    };
    remark(QStringLiteral("study"), completeness(before), completeness(after));
    if (!isSameFamily(before, after, ownSceneId))
        comparison.remarks << QStringLiteral("own scene: %1 before, %2 after; its times are not "
                                             "compared")
                                  .arg(textOf(before.family(ownSceneId)),
                                       textOf(after.family(ownSceneId)));
    QStringList others;
    for (const StudyFamily &family : before.families) {
        if (family.id != ownSceneId && after.family(family.id)
            && !isSameFamily(before, after, family.id))
            others << family.id;
    }
    if (!others.isEmpty())
        comparison.remarks << QStringLiteral("other triangles, times not compared: ")
                + others.join(QStringLiteral(", "));
    if (const QStringList changed = settingsChanged(before, after); !changed.isEmpty())
        comparison.remarks << QStringLiteral("other settings, times not compared: ")
                + changed.join(QStringLiteral(", "));
    return comparison;
}

QStringList textOf(const LabComparison &comparison)
{
    const QString line = QStringLiteral("%1 %2 %3 %4 %5  %6 %7 %8  %9");
    const auto padded = [](const QString &text, int width) { return text.leftJustified(width); };
    const auto right = [](const QString &text, int width) { return text.rightJustified(width); };
    const auto row = [&](const QString &contender, const QString &family, const QString &before,
                         const QString &after, const QString &times, const QString &change,
                         const QString &wrongBefore, const QString &wrongAfter,
                         const QString &remark) {
        const QString text = line.arg(padded(family, 15), padded(contender, 36), right(before, 10),
                                      right(after, 10), right(times, 7), padded(change, 14),
                                      right(wrongBefore, 11), right(wrongAfter, 11), remark);
        return text.trimmed();
    };
    QStringList lines = comparison.remarks;
    lines << row(QStringLiteral("contender"), QStringLiteral("family"), QStringLiteral("ns/px was"),
                 QStringLiteral("ns/px is"), QStringLiteral("times"), QStringLiteral("change"),
                 QStringLiteral("wrong was"), QStringLiteral("wrong is"), QString());
    for (const LabRowComparison &each : comparison.rows) {
        lines << row(each.contender, each.family, median(each.before), median(each.after),
                     number(each.timesBefore, 2), nameOf(each.change), number(each.wrongBefore, 2),
                     number(each.wrongAfter, 2),
                     each.isMissing              ? QStringLiteral("missing")
                         : each.isLessAccurate() ? QStringLiteral("less accurate")
                                                 : QString());
    }
    lines << QStringLiteral("%1 faster, %2 slower, %3 within spread, %4 not comparable; "
                            "%5 less accurate, %6 missing")
                 .arg(comparison.count(LabChange::Faster))
                 .arg(comparison.count(LabChange::Slower))
                 .arg(comparison.count(LabChange::WithinSpread))
                 .arg(comparison.count(LabChange::NotComparable))
                 .arg(comparison.countLessAccurate())
                 .arg(comparison.countMissing());
    return lines;
}

} // namespace pixelplumb
