// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradereports.h"
#include "core/grade/showntext.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pixelplumb {

namespace {

// The keys and their meanings: "Gradescope Autograder Documentation", Autograder Specifications,
// "Output format".
QJsonObject gradescopeJson(const GradedSubmission &submission, const Assignment &assignment)
{
    QJsonArray tests;
    for (const GradedScene &scene : submission.scenes) {
        for (const GradedCheck &check : scene.checks)
            tests.append(QJsonObject{{u"name"_s, u"%1: %2"_s.arg(scene.scene, nameOf(check.check))},
                                     {u"score"_s, check.points},
                                     {u"max_score"_s, check.of},
                                     {u"status"_s, check.isPassed ? u"passed"_s : u"failed"_s},
                                     {u"output"_s,
                                      check.isPassed || check.check != Check::Invariants
                                          ? scene.fault
                                          : scene.fault + submission.lostInvariants()},
                                     {u"visibility"_s, u"visible"_s}});
    }
    tests.append(QJsonObject{{u"name"_s, u"For the assistant"_s},
                             {u"score"_s, 0},
                             {u"max_score"_s, 0},
                             {u"output"_s, sentencesFor(submission, HintLevel::Full).join(u'\n')},
                             {u"visibility"_s, u"hidden"_s}});
    return {{u"score"_s, submission.points()},
            {u"output"_s, sentencesFor(submission, assignment.hint).join(u'\n')},
            {u"output_format"_s, u"text"_s},
            {u"visibility"_s, u"visible"_s},
            {u"stdout_visibility"_s, u"hidden"_s},
            {u"tests"_s, tests}};
}

} // namespace

QByteArray gradescopeOf(const GradedSubmission &submission, const Assignment &assignment)
{
    return escapedJson(QJsonDocument(gradescopeJson(submission, assignment)).toJson());
}

QByteArray gradescopeOf(const GradeReport &report)
{
    QJsonArray submissions;
    for (const GradedSubmission &submission : report.submissions) {
        QJsonObject object = gradescopeJson(submission, report.assignment);
        object.insert(u"name"_s, submission.name);
        object.insert(u"id"_s, submission.id);
        submissions.append(object);
    }
    QJsonObject object{{u"assignment"_s, report.assignment.name},
                       {u"max_score"_s, report.assignment.points()},
                       {u"submissions"_s, submissions}};
    if (!report.missing.isEmpty())
        object.insert(u"missing"_s, QJsonArray::fromStringList(report.missing));
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        object.insert(u"noSandbox"_s, text);
    return escapedJson(QJsonDocument(object).toJson());
}

} // namespace pixelplumb
