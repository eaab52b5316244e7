// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/grader.h"
#include "core/grade/class/gradereports.h"
#include "core/grade/class/resultsfolder.h"
#include "core/grade/showntext.h"

#include <QBuffer>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr const char *pageHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .25rem .75rem .25rem 0; vertical-align: top;
  border-bottom: 1px solid #8884; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
img { image-rendering: pixelated; width: 16rem; height: auto; border: 1px solid #8888; display: block; }
figure { display: inline-block; margin: 0 1rem 1rem 0; }
figcaption { font-size: .875rem; }
section { margin-top: 2.5rem; }
p.student { border-left: 3px solid #8888; padding-left: .75rem; }
summary { cursor: pointer; }
</style>
)";

QString html(const QString &text)
{
    return escapedLines(text).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

QString pointsHtml(double points) { return QString::number(points, 'g', 10); }

QString figure(const QImage &image, const QString &caption)
{
    QByteArray png;
    QBuffer buffer(&png);
    image.save(&buffer, "png");
    return QStringLiteral("<figure><img alt=\"%1\" src=\"data:image/png;base64,%2\">"
                          "<figcaption>%1</figcaption></figure>\n")
        .arg(html(caption), QString::fromLatin1(png.toBase64()));
}

QImage imageOf(const PictureDiff &diff, const Picture &expected)
{
    QImage image(diff.width, diff.height, QImage::Format_RGB32);
    for (int line = 0; line < diff.height; ++line) {
        for (int x = 0; x < diff.width; ++x) {
            const std::size_t place = expected.placeOf(x, line);
            const QRgb covered = expected.covered[place] != 0 ? qRgb(96, 96, 96) : qRgb(32, 32, 32);
            image.setPixel(x, line, markOf(diff.verdicts[place]).value_or(covered));
        }
    }
    return image;
}

/// Writes the page's parts.
class PageWriter {
public:
    PageWriter(const GradeReport &report, const QString &results)
        : m_report(report)
        , m_results(results)
        , m_grader(report.assignment)
    {
    }

    QByteArray page()
    {
        const QString name = html(m_report.assignment.name);
        m_page = QString::fromUtf8(pageHead)
            + QStringLiteral("<title>%1</title>\n</head>\n<body>\n<h1>%1</h1>\n").arg(name);
        const std::vector<GradeCluster> clusters = clustersOf(m_report);
        writeClusters(clusters);
        for (std::size_t i = 0; i < clusters.size(); ++i)
            writeCluster(clusters[i], i);
        m_page += QStringLiteral("</body>\n</html>\n");
        return m_page.toUtf8();
    }

private:
    void writeClusters(const std::vector<GradeCluster> &clusters)
    {
        m_page += QStringLiteral("<p>%1.</p>\n").arg(submissionsText(m_report.submissions.size()));
        if (!m_report.missing.isEmpty())
            m_page
                += QStringLiteral("<p><strong>Partial: %1 more without a grade.</strong> %2</p>\n")
                       .arg(m_report.missing.size())
                       .arg(html(m_report.missing.join(QStringLiteral(", "))));
        if (const QString text = unsandboxedText(m_report); !text.isEmpty())
            m_page += QStringLiteral("<p><strong>%1.</strong></p>\n").arg(html(text));
        m_page += QStringLiteral("<table>\n<tr><th class=\"number\">submissions</th>"
                                 "<th>cause</th><th>what was done</th></tr>\n");
        for (std::size_t i = 0; i < clusters.size(); ++i)
            m_page += QStringLiteral("<tr><td class=\"number\">%1</td><td><a href=\"#c%2\">%3</a>"
                                     "</td><td>%4</td></tr>\n")
                          .arg(clusters[i].submissions.size())
                          .arg(i)
                          .arg(html(clusters[i].title), html(clusters[i].forAssistant.join(u' ')));
        m_page += QStringLiteral("</table>\n");
    }

    void writeCluster(const GradeCluster &cluster, std::size_t number)
    {
        m_page += QStringLiteral("<section id=\"c%1\">\n<h2>%2</h2>\n")
                      .arg(number)
                      .arg(html(cluster.title));
        if (!cluster.forAssistant.isEmpty())
            m_page += QStringLiteral("<p>%1</p>\n").arg(html(cluster.forAssistant.join(u' ')));
        for (const std::size_t place : cluster.submissions)
            writeSubmission(m_report.submissions[place],
                            place == cluster.submissions.front() ? QStringLiteral(" open")
                                                                 : QString());
        m_page += QStringLiteral("</section>\n");
    }

    /// `open` is the attribute of details that are unfolded initially.
    void writeSubmission(const GradedSubmission &submission, const QString &open)
    {
        const Assignment &assignment = m_report.assignment;
        m_page += QStringLiteral("<h3>%1</h3>\n<p>%2 of %3 points%4</p>\n<p class=\"student\">%5"
                                 "</p>\n")
                      .arg(html(submission.name), pointsHtml(submission.points()),
                           pointsHtml(assignment.points()),
                           submission.review.isAccepted ? QStringLiteral(", accepted") : QString(),
                           html(sentencesFor(submission, assignment.hint).join(u'\n')));
        if (submission.verdict == GradeVerdict::Right && submission.lostInvariants().isEmpty())
            return;
        m_page += QStringLiteral("<details%1><summary>For the assistant</summary><p>%2</p>\n")
                      .arg(open, html(sentencesFor(submission, HintLevel::Full).join(u'\n')));
        for (std::size_t i = 0; i < submission.scenes.size(); ++i)
            writeScene(submission.scenes[i], i,
                       m_grader.in(submission.convention.value_or(FrameConvention::AsAsked)));
        m_page += QStringLiteral("</details>\n");
    }

    void writeScene(const GradedScene &scene, std::size_t place, const Grader &grader)
    {
        if (!scene.firstDifference || scene.picture.isEmpty())
            return;
        const auto content = ResultsFolder(m_results).read(scene.picture);
        const auto found
            = content ? parsePicture(*content, scene.picture) : Result<Picture>(content.error());
        const Picture &expected = grader.expected(place);
        if (!found || found->width != expected.width || found->height != expected.height)
            return;
        Picture picture = *found;
        if (picture.hasColours)
            coverAllBut(m_report.assignment.scenes[place].scene.frame.background, picture);
        const PictureDiff diff = differenceOf(expected, picture, grader.leftOpen(place, picture));
        m_page += QStringLiteral("<h4>%1</h4>\n").arg(html(scene.scene));
        m_page += figure(pixelplumb::imageOf(picture), QStringLiteral("found"));
        m_page += figure(pixelplumb::imageOf(expected), QStringLiteral("expected"));
        m_page
            += figure(imageOf(diff, expected),
                      QStringLiteral("%1 missing (orange), %2 extra (blue), %3 of another colour "
                                     "(purple), %4 undecidable (yellow)")
                          .arg(diff.count(Difference::Missing))
                          .arg(diff.count(Difference::Extra))
                          .arg(diff.count(Difference::Colour))
                          .arg(diff.count(Difference::Undecidable)));
    }

    const GradeReport &m_report;
    QString m_results;
    Grader m_grader;
    QString m_page;
};

} // namespace

QByteArray pageOf(const GradeReport &report, const QString &results)
{
    return PageWriter(report, results).page();
}

std::optional<InputError> writeReports(const QString &results, const GradeReport &report)
{
    const ResultsFolder folder(results);
    for (const GradedSubmission &submission : report.submissions) {
        const QString file = QStringLiteral("gradescope/%1.json").arg(submission.id);
        if (auto error = folder.write(file, gradescopeOf(submission, report.assignment)))
            return error;
    }
    const std::array<std::pair<const char *, QByteArray>, 4> files
        = {{{"results.json", gradescopeOf(report)},
            {"junit.xml", junitOf(report)},
            {"grades.csv", csvOf(report)},
            {"index.html", pageOf(report, results)}}};
    for (const auto &[name, content] : files) {
        if (auto error = folder.write(QLatin1String(name), content))
            return error;
    }
    return std::nullopt;
}

} // namespace pixelplumb
