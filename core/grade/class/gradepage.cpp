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
    return escapedLines(text).toHtmlEscaped().replace(u'\n', u"<br>"_s);
}

QString pointsHtml(double points) { return QString::number(points, 'g', 10); }

QString figure(const QImage &image, const QString &caption)
{
    QByteArray png;
    QBuffer buffer(&png);
    image.save(&buffer, "png");
    return u"<figure><img alt=\"%1\" src=\"data:image/png;base64,%2\">"
           "<figcaption>%1</figcaption></figure>\n"_s.arg(html(caption),
                                                          QString::fromLatin1(png.toBase64()));
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
            + u"<title>%1</title>\n</head>\n<body>\n<h1>%1</h1>\n"_s.arg(name);
        const std::vector<GradeCluster> clusters = clustersOf(m_report);
        writeClusters(clusters);
        for (std::size_t i = 0; i < clusters.size(); ++i)
            writeCluster(clusters[i], i);
        m_page += u"</body>\n</html>\n"_s;
        return m_page.toUtf8();
    }

private:
    void writeClusters(const std::vector<GradeCluster> &clusters)
    {
        m_page += u"<p>%1.</p>\n"_s.arg(submissionsText(m_report.submissions.size()));
        if (!m_report.missing.isEmpty())
            m_page += u"<p><strong>Partial: %1 more without a grade.</strong> %2</p>\n"_s
                          .arg(m_report.missing.size())
                          .arg(html(m_report.missing.join(u", "_s)));
        if (const QString text = unsandboxedText(m_report); !text.isEmpty())
            m_page += u"<p><strong>%1.</strong></p>\n"_s.arg(html(text));
        m_page += u"<table>\n<tr><th class=\"number\">submissions</th>"
                  "<th>cause</th><th>what was done</th></tr>\n"_s;
        for (std::size_t i = 0; i < clusters.size(); ++i)
            m_page += u"<tr><td class=\"number\">%1</td><td><a href=\"#c%2\">%3</a>"
                      "</td><td>%4</td></tr>\n"_s.arg(clusters[i].submissions.size())
                          .arg(i)
                          .arg(html(clusters[i].title), html(clusters[i].forAssistant.join(u' ')));
        m_page += u"</table>\n"_s;
    }

    void writeCluster(const GradeCluster &cluster, std::size_t number)
    {
        m_page += u"<section id=\"c%1\">\n<h2>%2</h2>\n"_s.arg(number).arg(html(cluster.title));
        if (!cluster.forAssistant.isEmpty())
            m_page += u"<p>%1</p>\n"_s.arg(html(cluster.forAssistant.join(u' ')));
        for (const std::size_t place : cluster.submissions)
            writeSubmission(m_report.submissions[place],
                            place == cluster.submissions.front() ? u" open"_s : QString());
        m_page += u"</section>\n"_s;
    }

    /// `open` is the attribute of details that are unfolded initially.
    void writeSubmission(const GradedSubmission &submission, const QString &open)
    {
        const Assignment &assignment = m_report.assignment;
        m_page += u"<h3>%1</h3>\n<p>%2 of %3 points%4</p>\n<p class=\"student\">%5"
                  "</p>\n"_s.arg(html(submission.name), pointsHtml(submission.points()),
                                 pointsHtml(assignment.points()),
                                 submission.review.isAccepted ? u", accepted"_s : QString(),
                                 html(sentencesFor(submission, assignment.hint).join(u'\n')));
        if (submission.verdict == GradeVerdict::Right && submission.lostInvariants().isEmpty())
            return;
        m_page += u"<details%1><summary>For the assistant</summary><p>%2</p>\n"_s.arg(
            open, html(sentencesFor(submission, HintLevel::Full).join(u'\n')));
        for (std::size_t i = 0; i < submission.scenes.size(); ++i)
            writeScene(submission.scenes[i], i,
                       m_grader.in(submission.convention.value_or(FrameConvention::AsAsked)));
        m_page += u"</details>\n"_s;
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
        const PictureDiff diff = grader.diffOf(place, picture);
        m_page += u"<h4>%1</h4>\n"_s.arg(html(scene.scene));
        m_page += figure(pixelplumb::imageOf(picture), u"found"_s);
        m_page += figure(pixelplumb::imageOf(expected), u"expected"_s);
        m_page += figure(imageOf(diff, expected),
                         u"%1 missing (orange), %2 extra (blue), %3 of another colour "
                         "(purple), %4 undecidable (yellow)"_s.arg(diff.count(Difference::Missing))
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
        const QString file = u"gradescope/%1.json"_s.arg(submission.id);
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
