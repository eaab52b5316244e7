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
    const QString lost = submission.lostInvariants().join(QStringLiteral(", "));
    QJsonArray tests;
    for (const GradedScene &scene : submission.scenes) {
        for (const GradedCheck &check : scene.checks)
            tests.append(QJsonObject{
                {QStringLiteral("name"),
                 QStringLiteral("%1: %2").arg(scene.scene, nameOf(check.check))},
                {QStringLiteral("score"), check.points},
                {QStringLiteral("max_score"), check.of},
                {QStringLiteral("status"),
                 check.isPassed ? QStringLiteral("passed") : QStringLiteral("failed")},
                {QStringLiteral("output"),
                 check.isPassed || check.check != Check::Invariants ? scene.fault
                                                                    : scene.fault + lost},
                {QStringLiteral("visibility"), QStringLiteral("visible")}});
    }
    tests.append(QJsonObject{
        {QStringLiteral("name"), QStringLiteral("For the assistant")},
        {QStringLiteral("score"), 0},
        {QStringLiteral("max_score"), 0},
        {QStringLiteral("output"), sentencesFor(submission, HintLevel::Full).join(u'\n')},
        {QStringLiteral("visibility"), QStringLiteral("hidden")}});
    return {{QStringLiteral("score"), submission.points()},
            {QStringLiteral("output"), sentencesFor(submission, assignment.hint).join(u'\n')},
            {QStringLiteral("output_format"), QStringLiteral("text")},
            {QStringLiteral("visibility"), QStringLiteral("visible")},
            {QStringLiteral("stdout_visibility"), QStringLiteral("hidden")},
            {QStringLiteral("tests"), tests}};
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
        object.insert(QStringLiteral("name"), submission.name);
        object.insert(QStringLiteral("id"), submission.id);
        submissions.append(object);
    }
    QJsonObject object{{QStringLiteral("assignment"), report.assignment.name},
                       {QStringLiteral("max_score"), report.assignment.points()},
                       {QStringLiteral("submissions"), submissions}};
    if (!report.missing.isEmpty())
        object.insert(QStringLiteral("missing"), QJsonArray::fromStringList(report.missing));
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        object.insert(QStringLiteral("noSandbox"), text);
    return escapedJson(QJsonDocument(object).toJson());
}

} // namespace pixelplumb
