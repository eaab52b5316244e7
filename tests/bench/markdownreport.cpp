// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbertext.h"
#include "report.h"

#include <QTextStream>

#include <algorithm>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

const QString memsetId = u"memset"_s;
const QString none = u"–"_s;

QString middleHalf(const Spread &spread)
{
    return u"%1 … %2"_s.arg(numberText(spread.lower), numberText(spread.upper));
}

QString percent(double share)
{
    if (share == 0)
        return u"0"_s;
    return u"%1 %"_s.arg(numberText(share * 100));
}

QString ratioCell(const ReportRow &row, const ReportRow *unit)
{
    return unit == nullptr ? none : numberText(ratio(row.result, unit->result).median);
}

QString nameOf(const ReportRow &row)
{
    const ContenderInfo &info = row.result.contender->info();
    const bool said = info.name.contains(QLatin1String("flat"));
    return info.shading == Shading::Flat && !said ? info.name + u", flat"_s : info.name;
}

/// Whether a picture clearly differs from the truth; the overview marks it.
bool isPoor(const ReportRow &row)
{
    return row.picture && (row.picture->coverage > 0.01 || row.picture->colour > 0.01);
}

/// Whether a wall time contains much of other programs' work.
bool isStarved(const Result &result)
{
    return result.contender->info().threads > 1
        && std::size_t(result.disturbedSamples) * 2 > result.nanosecondsPerTriangle.size();
}

/// The workload with the largest triangles, where memset's start-up costs least. Null without any.
const WorkloadReport *largestOf(const Report &report)
{
    const auto largest
        = std::ranges::max_element(report.workloads, {}, &WorkloadReport::pixelsPerTriangle);
    return largest == report.workloads.end() ? nullptr : &*largest;
}

void writeHeader(QTextStream &out, const Report &report)
{
    out << "# Triangles: ours, the peers, the memory\n\n"
        << markdown(report.machine) << "- load average " << numberText(report.loadAtEnd)
        << " at the end (1 is this program)\n";
    out << "- rounds: " << report.rounds << ", everyone once in each; medians, quartiles; ratios "
        << "are taken within a round. One-thread contenders by their processor time, others by "
        << "the wall clock.\n";
    if (const WorkloadReport *large = largestOf(report)) {
        if (const ReportRow *limit = large->row(memsetId)) {
            out << "- memset stores "
                << numberText(large->pixelsPerTriangle / limit->result.time().median)
                << " Gpixel/s (" << large->id << ")\n";
        }
    }
    if (report.extent == Extent::Quick)
        out << "- Quick run on shortened workloads: it shows that all works, not how fast.\n";
    std::size_t samples = 0;
    int disturbed = 0;
    for (const WorkloadReport &workload : report.workloads) {
        for (const ReportRow &row : workload.rows) {
            samples += row.result.nanosecondsPerTriangle.size();
            disturbed += row.result.disturbedSamples;
        }
    }
    out << "- " << disturbed << " of " << samples
        << " samples lost the processor to another program while they ran\n";
    for (const Absence &absence : report.absent)
        out << "- absent: " << absence.name << ": " << absence.reason << "\n";
    for (const QString &broken : report.brokenPromises())
        out << "- **" << broken << "**\n";
    out << "\n";
}

void writeLegend(QTextStream &out, const Report &report)
{
    out << "Workloads:\n\n";
    for (const WorkloadReport &workload : report.workloads) {
        out << "- " << workload.id << ": " << numberText(double(workload.triangles))
            << (workload.triangles == 1 ? " triangle " : " triangles ") << workload.title << ", "
            << numberText(workload.pixelsPerTriangle) << " px each\n";
    }
    out << "\n";
}

/// The table to look at first: rows are contenders, columns are workloads.
void writeOverview(QTextStream &out, const Report &report)
{
    out << "## ns per triangle, and times ours (" << report.referenceId << ")\n\n| renderer |";
    for (const WorkloadReport &workload : report.workloads)
        out << " " << workload.id << " |";
    out << "\n|---|";
    for (std::size_t column = 0; column < report.workloads.size(); ++column)
        out << "---:|";
    out << "\n";
    QStringList ids;
    for (const WorkloadReport &workload : report.workloads) {
        for (const ReportRow &row : workload.rows) {
            if (!ids.contains(row.result.contender->info().id))
                ids << row.result.contender->info().id;
        }
    }
    for (const QString &id : ids) {
        QString name;
        QString cells;
        for (const WorkloadReport &workload : report.workloads) {
            const ReportRow *row = workload.row(id);
            if (row == nullptr) {
                cells += u" %1 |"_s.arg(none);
                continue;
            }
            name = nameOf(*row);
            cells += u" %1 (%2)%3 |"_s.arg(numberText(row->result.time().median),
                                           ratioCell(*row, workload.row(report.referenceId)),
                                           isPoor(*row) ? u" !"_s : QString());
        }
        out << "| " << name << " |" << cells << "\n";
    }
    out << "\n`!`: more than 1 % of the pixels are covered wrongly or more than one level off; "
           "see below.\n\n";
}

/// Writes each plain kernel's time as a multiple of its straight loop's.
void writeTwins(QTextStream &out, const Report &report)
{
    QStringList lines;
    for (const WorkloadReport &workload : report.workloads) {
        for (const ReportRow &row : workload.rows) {
            const ContenderInfo &info = row.result.contender->info();
            const ReportRow *twin = workload.row(info.twinId);
            if (twin == nullptr)
                continue;
            const Spread times = ratio(row.result, twin->result);
            lines << u"| %1 | %2 | %3 | %4 |"_s.arg(workload.id, info.name,
                                                    numberText(times.median), middleHalf(times));
        }
    }
    if (lines.isEmpty())
        return;
    out << "## Plain kernels, times their straight loops\n\n"
           "| workload | kernel | times | quartiles |\n|---|---|--:|--:|\n"
        << lines.join(QLatin1Char('\n')) << "\n\n";
}

void writeRow(QTextStream &out, const WorkloadReport &workload, const ReportRow &row,
              const Report &report)
{
    const Result &result = row.result;
    const ReportRow *reference = workload.row(report.referenceId);
    const Spread time = result.time();
    out << "| " << workload.id << " | " << nameOf(row) << " | " << result.contender->info().threads
        << (isStarved(result) ? " ~" : "") << " | "
        << numberText(spreadOf(result.processorsUsed).median) << " | " << numberText(time.median)
        << " | " << middleHalf(time) << " | " << ratioCell(row, reference) << " | "
        << (reference == nullptr ? none : middleHalf(ratio(result, reference->result))) << " | "
        << ratioCell(row, workload.row(memsetId)) << " | "
        << numberText(time.median / workload.pixelsPerTriangle) << " | ";
    if (row.picture) {
        const LatticePoint &offset = result.contender->info().sampleOffset;
        out << row.picture->rule.name
            << (offset == LatticePoint() ? "" : ", samples half a pixel beside") << " | "
            << percent(row.picture->coverage) << " | " << percent(row.picture->colour) << " | "
            << percent(row.picture->bytes) << " | ";
    } else {
        out << none << " | " << none << " | " << none << " | " << none << " | ";
    }
    out << (result.triangles < workload.triangles ? numberText(double(result.triangles)) : u"all"_s)
        << " |\n";
}

} // namespace

QString markdown(const Report &report)
{
    QString text;
    QTextStream out(&text);
    writeHeader(out, report);
    writeLegend(out, report);
    writeOverview(out, report);
    writeTwins(out, report);
    out << "## Everything\n\n"
           "Used: processors that the threads had; `~`: they lost one to another program in most "
           "samples, while the wall clock ran on. Pictures: the rule that comes nearest, and the "
           "share of the true picture's pixels that are covered wrongly, more than one level off, "
           "or not the same bytes; by the oracle, on triangles of the workload that do not touch. "
           "A rule is named, or given by the infinitely small displacement of the samples, y "
           "upward.\n\n"
           "| workload | renderer | threads | used | ns/triangle | quartiles | × ours | "
           "quartiles | × memset | ns/px | nearest rule | coverage | colour | bytes | "
           "triangles |\n"
           "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|\n";
    for (const WorkloadReport &workload : report.workloads) {
        for (const ReportRow &row : workload.rows)
            writeRow(out, workload, row, report);
    }
    return text;
}

} // namespace pixelplumb::bench
