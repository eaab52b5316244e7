// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/rowwriter.h"
#include "core/export/spreadsheettext.h"
#include "core/grade/class/gradereports.h"
#include "core/grade/showntext.h"

#include <QBuffer>
#include <QXmlStreamWriter>

#include <algorithm>

namespace pixelplumb {

namespace {

QString pointsText(double points) { return QString::number(points, 'g', 10); }

QString defectsText(const GradedSubmission &submission)
{
    QStringList sets;
    for (const GradedCandidate &candidate : submission.candidates) {
        if (candidate.distance == 0)
            sets += candidate.defects.join(u'+');
    }
    return sets.join(QStringLiteral(" | "));
}

/// Empty if some picture could not be judged: then the count is unknown.
QString differingText(const GradedSubmission &submission)
{
    const bool isJudged = std::ranges::all_of(
        submission.scenes, [](const GradedScene &scene) { return scene.fault.isEmpty(); });
    return isJudged ? QString::number(submission.differing) : QString();
}

/// Whether its programs ran in a sandbox; empty where none was run.
QString sandboxText(const GradedSubmission &submission)
{
    const auto isIn = isSandboxed(submission);
    return isIn ? (*isIn ? QStringLiteral("yes") : QStringLiteral("no")) : QString();
}

/// XML allows no control characters.
QString xmlText(const QStringList &lines) { return shownText(lines.join(u'\n').toUtf8(), 100'000); }

struct TestCounts {
    std::size_t tests = 0, failures = 0, skipped = 0;
};

void beginSuite(QXmlStreamWriter &xml, const QString &name, const TestCounts &counts)
{
    xml.writeStartElement(QStringLiteral("testsuite"));
    xml.writeAttribute(QStringLiteral("name"), name);
    xml.writeAttribute(QStringLiteral("tests"), QString::number(counts.tests));
    xml.writeAttribute(QStringLiteral("failures"), QString::number(counts.failures));
    xml.writeAttribute(QStringLiteral("errors"), QStringLiteral("0"));
    xml.writeAttribute(QStringLiteral("skipped"), QString::number(counts.skipped));
}

void beginCase(QXmlStreamWriter &xml, const QString &suite, const QString &name)
{
    xml.writeStartElement(QStringLiteral("testcase"));
    xml.writeAttribute(QStringLiteral("classname"), suite);
    xml.writeAttribute(QStringLiteral("name"), name);
}

void writeSubmission(QXmlStreamWriter &xml, const GradedSubmission &submission, HintLevel hint)
{
    const QString name = xmlText({submission.name});
    TestCounts counts;
    for (const GradedScene &scene : submission.scenes) {
        counts.tests += scene.checks.size();
        for (const GradedCheck &check : scene.checks)
            counts.failures += check.isPassed ? 0 : 1;
    }
    beginSuite(xml, name, counts);
    const QString told = xmlText(sentencesFor(submission, hint));
    for (const GradedScene &scene : submission.scenes) {
        for (const GradedCheck &check : scene.checks) {
            beginCase(xml, name,
                      xmlText({QStringLiteral("%1: %2").arg(scene.scene, nameOf(check.check))}));
            if (!check.isPassed) {
                xml.writeStartElement(QStringLiteral("failure"));
                xml.writeAttribute(
                    QStringLiteral("message"),
                    xmlText({scene.fault.isEmpty() ? verdictText(submission) : scene.fault}));
                xml.writeCharacters(told);
                xml.writeEndElement();
            }
            xml.writeEndElement();
        }
    }
    if (const QString text = unsandboxedText(submission); !text.isEmpty())
        xml.writeTextElement(QStringLiteral("system-err"), xmlText({text}));
    xml.writeEndElement();
}

/// A submission without a grade here: nothing is known, and nothing failed.
void writeUngraded(QXmlStreamWriter &xml, const QString &submission)
{
    const QString name = xmlText({submission});
    beginSuite(xml, name, {.tests = 1, .skipped = 1});
    beginCase(xml, name, QStringLiteral("no grade"));
    xml.writeEmptyElement(QStringLiteral("skipped"));
    xml.writeAttribute(QStringLiteral("message"), QStringLiteral("no grade"));
    xml.writeEndElement();
    xml.writeEndElement();
}

/// Words of people, who may paste anything.
QString cellText(const QString &text) { return spreadsheetText(escapedLines(text)); }

} // namespace

QByteArray csvOf(const GradeReport &report)
{
    QByteArray csv;
    QBuffer buffer(&csv);
    buffer.open(QIODevice::WriteOnly);
    const auto writer = makeCsvWriter(buffer);
    std::vector<Field> fields;
    for (const char *name : {"name", "points", "of", "verdict", "differing", "defects", "sentences",
                             "comment", "accepted", "id", "sandbox", "reason"})
        fields.push_back({QString::fromLatin1(name)});
    writer->begin(fields);
    for (const GradedSubmission &each : report.submissions)
        writer->writeRow(
            {spreadsheetText(each.name), pointsText(each.points()),
             pointsText(report.assignment.points()), verdictText(each), differingText(each),
             defectsText(each),
             cellText(sentencesFor(each, report.assignment.hint).join(QStringLiteral(" / "))),
             cellText(each.review.comment),
             each.review.isAccepted ? QStringLiteral("yes") : QStringLiteral("no"),
             each.id, // begins with a letter, a digit or _
             sandboxText(each), cellText(each.review.reason.value_or(QString()))});
    for (const QString &name : report.missing)
        writer->writeRow({spreadsheetText(name), QString(), pointsText(report.assignment.points()),
                          QStringLiteral("no grade"), QString(), QString(), QString(), QString(),
                          QStringLiteral("no"), QString(), QString(), QString()});
    writer->end();
    return csv;
}

QByteArray junitOf(const GradeReport &report)
{
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.setAutoFormatting(true);
    xml.writeStartDocument();
    xml.writeStartElement(QStringLiteral("testsuites"));
    xml.writeAttribute(QStringLiteral("name"), xmlText({report.assignment.name}));
    for (const GradedSubmission &submission : report.submissions)
        writeSubmission(xml, submission, report.assignment.hint);
    for (const QString &name : report.missing)
        writeUngraded(xml, name);
    xml.writeEndElement();
    xml.writeEndDocument();
    return bytes;
}

} // namespace pixelplumb
