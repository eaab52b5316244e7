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
    return sets.join(u" | "_s);
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
    return isIn ? (*isIn ? u"yes"_s : u"no"_s) : QString();
}

/// XML allows no control characters.
QString xmlText(const QStringList &lines) { return shownText(lines.join(u'\n').toUtf8(), 100'000); }

struct TestCounts {
    std::size_t tests = 0, failures = 0, skipped = 0;
};

void beginSuite(QXmlStreamWriter &xml, const QString &name, const TestCounts &counts)
{
    xml.writeStartElement(u"testsuite"_s);
    xml.writeAttribute(u"name"_s, name);
    xml.writeAttribute(u"tests"_s, QString::number(counts.tests));
    xml.writeAttribute(u"failures"_s, QString::number(counts.failures));
    xml.writeAttribute(u"errors"_s, u"0"_s);
    xml.writeAttribute(u"skipped"_s, QString::number(counts.skipped));
}

void beginCase(QXmlStreamWriter &xml, const QString &suite, const QString &name)
{
    xml.writeStartElement(u"testcase"_s);
    xml.writeAttribute(u"classname"_s, suite);
    xml.writeAttribute(u"name"_s, name);
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
            beginCase(xml, name, xmlText({u"%1: %2"_s.arg(scene.scene, nameOf(check.check))}));
            if (!check.isPassed) {
                xml.writeStartElement(u"failure"_s);
                xml.writeAttribute(
                    u"message"_s,
                    xmlText({scene.fault.isEmpty() ? verdictText(submission) : scene.fault}));
                xml.writeCharacters(told);
                xml.writeEndElement();
            }
            xml.writeEndElement();
        }
    }
    if (const QString text = unsandboxedText(submission); !text.isEmpty())
        xml.writeTextElement(u"system-err"_s, xmlText({text}));
    xml.writeEndElement();
}

/// A submission without a grade here: nothing is known, and nothing failed.
void writeUngraded(QXmlStreamWriter &xml, const QString &submission)
{
    const QString name = xmlText({submission});
    beginSuite(xml, name, {.tests = 1, .skipped = 1});
    beginCase(xml, name, u"no grade"_s);
    xml.writeEmptyElement(u"skipped"_s);
    xml.writeAttribute(u"message"_s, u"no grade"_s);
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
             defectsText(each), cellText(sentencesFor(each, report.assignment.hint).join(u" / "_s)),
             cellText(each.review.comment), each.review.isAccepted ? u"yes"_s : u"no"_s,
             each.id, // begins with a letter, a digit or _
             sandboxText(each), cellText(each.review.reason.value_or(QString()))});
    for (const QString &name : report.missing)
        writer->writeRow({spreadsheetText(name), QString(), pointsText(report.assignment.points()),
                          u"no grade"_s, QString(), QString(), QString(), QString(), u"no"_s,
                          QString(), QString(), QString()});
    writer->end();
    return csv;
}

QByteArray junitOf(const GradeReport &report)
{
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.setAutoFormatting(true);
    xml.writeStartDocument();
    xml.writeStartElement(u"testsuites"_s);
    xml.writeAttribute(u"name"_s, xmlText({report.assignment.name}));
    for (const GradedSubmission &submission : report.submissions)
        writeSubmission(xml, submission, report.assignment.hint);
    for (const QString &name : report.missing)
        writeUngraded(xml, name);
    xml.writeEndElement();
    xml.writeEndDocument();
    return bytes;
}

} // namespace pixelplumb
