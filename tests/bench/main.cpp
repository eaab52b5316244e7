// SPDX-License-Identifier: GPL-3.0-or-later
#include "labstudy.h"
#include "report.h"
#include "scaling.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QSaveFile>

#include <unistd.h>

#include <cstdio>

using namespace pixelplumb::bench;
using namespace Qt::StringLiterals;

namespace {

enum ExitCode { Done = 0, WrongPicture = 1, Usage = 2 };

struct Options {
    Extent extent = Extent::Full;
    QRegularExpression filter;
    int rounds = 0;
    bool scaling = false;
    bool list = false;
    QString labFile;

    RaceOptions race() const
    {
        RaceOptions options;
        options.rounds = rounds;
        if (extent == Extent::Quick) {
            options.sampleNanoseconds = 1e6;
            options.longestDraw = 20e6;
        }
        return options;
    }
};

/// Shows a line on stderr that the next one overwrites; nothing if stderr is no terminal.
void showProgress(const QString &text)
{
    if (isatty(STDERR_FILENO) != 0)
        std::fprintf(stderr, "\r\033[K%s", qPrintable(text));
}

[[noreturn]] void refuse(const QString &message)
{
    std::fprintf(stderr, "bench: %s\n", qPrintable(message));
    std::exit(Usage);
}

Options parse(const QCoreApplication &application)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        u"Times triangles drawn by our kernels, by other renderers, and by memset."_s);
    const QCommandLineOption quick(u"quick"_s, u"Short workloads, 3 rounds."_s);
    const QCommandLineOption filter(
        u"filter"_s,
        u"Only what <expression> matches in WORKLOAD/CONTENDER, such as W4/sdl2. "
        "The reference and memset always run."_s,
        u"expression"_s);
    const QCommandLineOption rounds(u"rounds"_s, u"Samples of everyone (11; 3 when quick)."_s,
                                    u"count"_s);
    const QCommandLineOption scaling(
        u"scaling"_s, u"Our kernels over growing numbers of triangles and growing frames."_s);
    const QCommandLineOption list(u"list"_s, u"Name workloads and contenders."_s);
    const QCommandLineOption labFile(
        u"lab"_s,
        u"The lab's study with the other renderers among its contenders, written to "
        "<file>, which the lab opens; its --quick or --full."_s,
        u"file"_s);
    parser.addOptions({quick, filter, rounds, scaling, list, labFile});
    parser.addHelpOption();
    parser.process(application);

    Options options;
    options.extent = parser.isSet(quick) ? Extent::Quick : Extent::Full;
    options.filter.setPattern(parser.value(filter));
    options.rounds = options.extent == Extent::Quick ? 3 : 11;
    options.scaling = parser.isSet(scaling);
    options.list = parser.isSet(list);
    options.labFile = parser.value(labFile);
    if (!options.filter.isValid()) {
        refuse(u"--filter %1: %2"_s.arg(options.filter.pattern(), options.filter.errorString()));
    }
    if (parser.isSet(rounds)) {
        options.rounds = parser.value(rounds).toInt();
        if (options.rounds < 1) {
            refuse(u"--rounds %1: expected a whole number from 1"_s.arg(parser.value(rounds)));
        }
    }
    if (!parser.positionalArguments().isEmpty())
        refuse(u"unexpected argument %1"_s.arg(parser.positionalArguments().first()));
    return options;
}

/// The contenders for a workload: those that pass the filter, and the reference of the ratios.
std::vector<Contender *> contendersFor(const QString &workloadId, const Lineup &lineup,
                                       const Options &options)
{
    std::vector<Contender *> chosen;
    bool any = false;
    for (const std::unique_ptr<Contender> &contender : lineup.contenders) {
        const ContenderInfo &info = contender->info();
        const bool matches
            = options.filter.match(workloadId + QLatin1Char('/') + info.id).hasMatch();
        any = any || matches;
        if (matches || info.id == lineup.referenceId || info.role == Role::Limit)
            chosen.push_back(contender.get());
    }
    if (!any)
        chosen.clear();
    return chosen;
}

/// Compares every contender's picture with the oracle's, in their order; nothing for a limit.
std::vector<std::optional<PictureDifference>> lookAtPictures(
    const Workload &workload, const std::vector<Contender *> &contenders, Extent extent)
{
    PictureCheck check(workload, extent);
    std::vector<std::optional<PictureDifference>> differences;
    for (Contender *contender : contenders) {
        showProgress(u"%1: looking at %2"_s.arg(workload.id, contender->info().name));
        differences.emplace_back();
        if (contender->hasPicture())
            differences.back() = check.check(*contender);
    }
    return differences;
}

WorkloadReport reportOn(const Workload &workload, const std::vector<Contender *> &contenders,
                        const Options &options)
{
    WorkloadReport report;
    report.id = workload.id;
    report.title = workload.title;
    report.size = workload.size;
    report.triangles = workload.triangles.size();
    report.pixelsPerTriangle
        = double(coveredSamples(workload.triangles)) / double(workload.triangles.size());

    const std::vector<std::optional<PictureDifference>> pictures
        = lookAtPictures(workload, contenders, options.extent);
    Forms forms(workload);
    std::vector<Result> results = race(workload, forms, contenders, options.race(), showProgress);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ContenderInfo &info = contenders[i]->info();
        std::optional<double> differsFromPlain;
        if (info.sameAsPlain) {
            showProgress(u"%1: looking at all of %2"_s.arg(workload.id, info.name));
            const Scene scene = forms.scene(info.shading, results[i].triangles);
            differsFromPlain
                = differingShare(contenders[i]->picture(), plainPicture(scene, *info.sameAsPlain));
        }
        report.rows.push_back({std::move(results[i]), pictures[i], differsFromPlain});
    }
    return report;
}

void write(const QByteArray &content, const QString &name)
{
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit())
        refuse(u"%1 cannot be written: %2"_s.arg(name, file.errorString()));
}

void print(const QString &text)
{
    showProgress({});
    std::fputs(qUtf8Printable(text), stdout);
}

void list(const Lineup &lineup, const Options &options)
{
    for (const Workload &workload : standardWorkloads(options.extent))
        std::printf("%-10s %s\n", qPrintable(workload.id), qPrintable(workload.title));
    for (const std::unique_ptr<Contender> &contender : lineup.contenders) {
        std::printf("%-24s %s\n", qPrintable(contender->info().id),
                    qPrintable(contender->info().name));
    }
    for (const Absence &absence : lineup.absent)
        std::printf("absent: %s: %s\n", qPrintable(absence.name), qPrintable(absence.reason));
}

int measureScalings(const Lineup &lineup, const Options &options)
{
    // Without a filter: the reference of the ratios, and the plain kernel.
    std::vector<Contender *> contenders;
    for (const std::unique_ptr<Contender> &contender : lineup.contenders) {
        const ContenderInfo &info = contender->info();
        const bool wanted = options.filter.pattern().isEmpty()
            ? info.id == QLatin1String("plain-half-open")
            : options.filter.match(QLatin1Char('/') + info.id).hasMatch();
        if (wanted || info.id == lineup.referenceId || info.role == Role::Limit)
            contenders.push_back(contender.get());
    }
    const pixelplumb::MachineConditions machine = pixelplumb::thisMachine();
    std::vector<ScalingResult> series;
    for (const ScalingPoint &point : scalingPoints(options.extent)) {
        series.push_back(
            measureScaling(point, contenders, lineup.referenceId, options.race(), showProgress));
    }
    print(markdown(machine, series));
    return Done;
}

int measureWorkloads(const Lineup &lineup, const Options &options)
{
    Report report;
    report.machine = pixelplumb::thisMachine();
    report.rounds = options.rounds;
    report.extent = options.extent;
    report.referenceId = lineup.referenceId;
    report.absent = lineup.absent;
    for (const Workload &workload : standardWorkloads(options.extent)) {
        const std::vector<Contender *> contenders = contendersFor(workload.id, lineup, options);
        if (!contenders.empty())
            report.workloads.push_back(reportOn(workload, contenders, options));
    }
    if (report.workloads.empty())
        refuse(u"--filter %1 matches nothing; --list names what there is"_s.arg(
            options.filter.pattern()));
    report.loadAtEnd = pixelplumb::loadNow();
    print(markdown(report));
    return report.brokenPromises().isEmpty() ? Done : WrongPicture;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const Options options = parse(application);
    const Lineup lineup = makeLineup();
    if (options.list) {
        list(lineup, options);
        return Done;
    }
    if (!options.labFile.isEmpty()) {
        write(studyWithPeers(lineup, options.extent, showProgress), options.labFile);
        std::fprintf(stderr, "The study is in %s\n", qPrintable(options.labFile));
        return Done;
    }
    if (options.scaling)
        return measureScalings(lineup, options);
    return measureWorkloads(lineup, options);
}
