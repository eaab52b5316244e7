// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/performancetext.h"

#include "widgets/look/blend.h"
#include "widgets/look/numberformat.h"

#include <QCoreApplication>

#include <cmath>

namespace pixelplumb {

namespace {

struct PerformanceText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PerformanceText)
};

/// A number with three digits, in groups of thousands.
QString rounded(double value)
{
    if (!(value > 0))
        return QStringLiteral("0");
    const int places = std::clamp(2 - int(std::floor(std::log10(value))), 0, 4);
    return groupedText(value, places);
}

QString cell(const QString &text) { return QStringLiteral("<td align='right'>%1</td>").arg(text); }

QString timeRow(const QString &who, const DrawTime &time, const SceneTiming &timing)
{
    const Spread &spread = time.perDraw;
    const auto percent = [&](double value) {
        return QString::number(std::abs(value / spread.median - 1) * 100, 'f', 0);
    };
    return QStringLiteral("<tr><td>%1</td>").arg(who) + cell(rounded(time.perPixel(timing.pixels)))
        + cell(rounded(time.perTriangle(timing.triangles)))
        + cell(QStringLiteral("−%1 … +%2 %").arg(percent(spread.lower), percent(spread.upper)))
        + cell(QStringLiteral("%1 ×").arg(
            rounded(timing.plain.perDraw.median / time.perDraw.median)))
        + cell(QStringLiteral("%1 %").arg(
            QString::number(100 * timing.shareOfMemory(time), 'f', 0)))
        + QStringLiteral("</tr>");
}

} // namespace

QString timesHtml(const SceneTiming &timing)
{
    QString html
        = QStringLiteral("<table width='100%' cellspacing='0' cellpadding='2'><tr><td></td>");
    for (const QString &heading :
         {PerformanceText::tr("ns a pixel"), PerformanceText::tr("ns a triangle"),
          PerformanceText::tr("quartiles"), PerformanceText::tr("speed"),
          PerformanceText::tr("of memory")})
        html += cell(heading);
    html += QStringLiteral("</tr>");
    html += timeRow(PerformanceText::tr("plain kernel"), timing.plain, timing);
    html += timeRow(PerformanceText::tr("fast, %1")
                        .arg(QString::fromUtf8(nameOf(timing.report.instructionSet))),
                    timing.fast, timing);
    if (timing.parallel) {
        html += timeRow(PerformanceText::tr("fast, %1 threads").arg(timing.parallel->threads),
                        *timing.parallel, timing);
    }
    html += timeRow(PerformanceText::tr("memory: memset"), timing.memory, timing);
    return html + QStringLiteral("</table>");
}

QString routesHtml(const FastReport &report, const QPalette &palette)
{
    const QColor dim
        = blended(palette.color(QPalette::Window), palette.color(QPalette::WindowText), 0.72F);
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='2'>");
    for (const FastRouteUse &use : report.uses) {
        QString kernel = QString::fromUtf8(nameOf(use.kernel));
        if (use.word != ColourWord::Other)
            kernel += PerformanceText::tr(", colours: %1").arg(QString::fromUtf8(nameOf(use.word)));
        html += QStringLiteral("<tr>") + cell(groupedText(use.triangles))
            + QStringLiteral("<td>&nbsp;%1<br><span style='color:%2'>&nbsp;%3</span></td></tr>")
                  .arg(kernel, dim.name(),
                       QString::fromUtf8(pixelplumb::textOf(use.reason)).toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

QString measurementText(const SceneTiming &timing)
{
    if (timing.triangles == 0)
        return PerformanceText::tr("The scene has no triangles to draw.");
    if (timing.pixels == 0)
        return PerformanceText::tr("The scene's triangles cover no pixel of the frame.");
    const QString triangles = PerformanceText::tr("%1 triangles", nullptr, int(timing.triangles))
                                  .arg(groupedText(timing.triangles));
    const QString pixels = PerformanceText::tr("%1 pixels", nullptr, int(timing.pixels))
                               .arg(groupedText(timing.pixels));
    return PerformanceText::tr("Column scan, %1, %2: %3, %4 written. Medians of %5 rounds. %6")
        .arg(QString::fromUtf8(nameOf(timing.settings.arithmetic)),
             QString::fromUtf8(nameOf(timing.settings.fillRule)), triangles, pixels,
             QString::number(timing.rounds),
             timing.sameBytes ? PerformanceText::tr("Both kernels draw the same bytes.")
                              : PerformanceText::tr("The kernels draw different bytes!"));
}

} // namespace pixelplumb
