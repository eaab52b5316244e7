// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cases/hardcasespicture.h"

#include "core/check/casepicture.h"
#include "widgets/look/corewords.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

#include <QtWidgets>

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

constexpr QSize cropSize(36, 24); ///< frame pixels
constexpr int leastOutlinedCell = 4; ///< logical pixels

Difference differenceAt(const WrittenFrame &drawn, const WrittenFrame &truth, std::int64_t x,
                        std::int64_t y)
{
    if (drawn.isWritten(x, y) != truth.isWritten(x, y))
        return truth.isWritten(x, y) ? Difference::Missing : Difference::Extra;
    return *drawn.view().at(x, y) == *truth.view().at(x, y) ? Difference::None : Difference::Colour;
}

/// Finds what a crop should show in its middle.
class Focus {
public:
    void see(std::int64_t x, std::int64_t y, Difference kind, bool isCovered)
    {
        const QPoint pixel{int(x), int(y)};
        const bool isCoverage = kind == Difference::Missing || kind == Difference::Extra;
        if (isCoverage && !m_coverage)
            m_coverage = pixel;
        if (kind == Difference::Colour && !m_colour)
            m_colour = pixel;
        if (isCovered) {
            m_sum += QPointF(pixel);
            m_covered.push_back(pixel);
        }
    }
    QPoint pixel(const FrameSpec &frame) const
    {
        if (m_coverage)
            return *m_coverage;
        if (m_colour)
            return *m_colour;
        if (!m_covered.empty()) {
            const QPointF middle = m_sum / double(m_covered.size());
            return *std::ranges::min_element(m_covered, {}, [&middle](const QPoint &pixel) {
                return (QPointF(pixel) - middle).manhattanLength();
            });
        }
        return {frame.firstColumn + frame.width / 2, frame.firstRow + frame.height / 2};
    }

private:
    std::optional<QPoint> m_coverage, m_colour;
    QPointF m_sum; ///< of the covered pixels
    std::vector<QPoint> m_covered;
};

QImage crop(const WrittenFrame &written, const FrameSpec &frame, const QRect &part)
{
    QImage picture(part.size(), QImage::Format_RGB32);
    for (int row = 0; row < part.height(); ++row) {
        auto *const pixels = reinterpret_cast<QRgb *>(picture.scanLine(part.height() - 1 - row));
        for (int column = 0; column < part.width(); ++column) {
            const std::int64_t x = part.left() + column;
            const std::int64_t y = part.top() + row;
            pixels[column]
                = packed(written.isWritten(x, y) ? written.colourAt(x, y) : frame.background);
        }
    }
    return picture;
}

/// The edges in pixels of a part of the frame, from its upper left.
std::vector<QLineF> edgesOf(const Primitives &primitives, const QRect &part)
{
    const auto placed = [&part](const LatticePoint &point) {
        return QPointF(double(point.x) / unitsPerPixel - part.left() + 0.5,
                       part.top() + part.height() - 0.5 - double(point.y) / unitsPerPixel);
    };
    std::vector<QLineF> edges;
    for (const Triangle &triangle : primitives.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            edges.emplace_back(placed(triangle.vertices[i].position),
                               placed(triangle.vertices[(i + 1) % 3].position));
    }
    return edges;
}

/// Paints edges over a picture that is enlarged into a rectangle.
void paintEdges(QPainter &painter, const std::vector<QLineF> &edges, const QRect &place, int cell,
                const QPalette &palette)
{
    painter.save();
    painter.setClipRect(place);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor casing = isDark(palette) ? Qt::black : Qt::white;
    casing.setAlphaF(0.8F);
    for (const QPen &pen : {QPen(casing, 3), QPen(signColour(Sign::VertexMark, palette), 1)}) {
        painter.setPen(pen);
        for (const QLineF &edge : edges) {
            const QLineF enlarged(place.topLeft() + edge.p1() * cell,
                                  place.topLeft() + edge.p2() * cell);
            if (const auto visible = clipped(enlarged, QRectF(place).adjusted(-4, -4, 4, 4)))
                painter.drawLine(*visible);
        }
    }
    painter.restore();
}

struct CaseVerdict {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::HardCasePicture)
};

/// The verdicts of one method and arithmetic over its rules, as one cell.
struct Cell {
    int passed = 0;
    int fellShort = 0;
    QStringList remarks;

    void add(const ContenderVerdict &verdict)
    {
        passed += verdict.outcome == CaseOutcome::Passed ? 1 : 0;
        fellShort += verdict.outcome == CaseOutcome::FellShort ? 1 : 0;
        if (verdict.outcome == CaseOutcome::FellShort)
            remarks.append(verdict.contender.name() + QStringLiteral(": ")
                           + verdict.remarks.join(QStringLiteral("; ")));
    }
    QString toolTip() const
    {
        if (passed + fellShort == 0)
            return HardCasesVerdicts::tr("the case has no facts under its rules");
        return remarks.isEmpty()
            ? HardCasesVerdicts::tr("right under every rule that the case knows")
            : remarks.join(u'\n');
    }
    QString text() const
    {
        if (passed + fellShort == 0)
            return QStringLiteral("·");
        return fellShort == 0 ? QStringLiteral("✓") : QStringLiteral("✗");
    }
};

} // namespace

QString HardCasePicture::verdict() const
{
    QStringList parts;
    if (missing > 0)
        parts.append(CaseVerdict::tr("%1 missing").arg(missing));
    if (extra > 0)
        parts.append(CaseVerdict::tr("%1 extra").arg(extra));
    if (otherColour > 0)
        parts.append(CaseVerdict::tr("%1 in another colour").arg(otherColour));
    return parts.isEmpty() ? CaseVerdict::tr("correct") : parts.join(QStringLiteral(", "));
}

HardCasePicture pictureOf(const HardCase &hardCase, const Method &method,
                          const ScanSettings &settings)
{
    const Scene scene = sceneOf(hardCase, method, settings);
    HardCasePicture picture;
    const SceneRun run(scene);
    picture.contender = {run.method, run.settings};
    const WrittenFrame drawn(scene.frame);
    const WrittenFrame truth(scene.frame);
    run.draw(drawn.view());
    run.drawTruth(truth.view());

    Focus focus;
    const FrameView window = drawn.view();
    for (std::int64_t x = window.firstColumn; x < window.endColumn(); ++x) {
        for (std::int64_t y = window.firstRow; y < window.endRow(); ++y) {
            const Difference kind = differenceAt(drawn, truth, x, y);
            picture.missing += kind == Difference::Missing ? 1 : 0;
            picture.extra += kind == Difference::Extra ? 1 : 0;
            picture.otherColour += kind == Difference::Colour ? 1 : 0;
            focus.see(x, y, kind, truth.isWritten(x, y));
        }
    }
    const QPoint middle = focus.pixel(scene.frame);
    const int width = std::min(cropSize.width(), scene.frame.width);
    const int height = std::min(cropSize.height(), scene.frame.height);
    const auto placed = [](int centre, int size, std::int64_t first, std::int64_t end) {
        return int(std::clamp<std::int64_t>(centre - size / 2, first, end - size));
    };
    picture.firstPixel = {placed(middle.x(), width, window.firstColumn, window.endColumn()),
                          placed(middle.y(), height, window.firstRow, window.endRow())};
    const QRect part(picture.firstPixel, QSize(width, height));
    picture.drawn = crop(drawn, scene.frame, part);
    picture.truth = crop(truth, scene.frame, part);
    picture.edges = edgesOf(run.primitives, part);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Difference kind
                = differenceAt(drawn, truth, part.left() + column, part.top() + row);
            if (kind != Difference::None)
                picture.marks.emplace_back(QPoint(column, height - 1 - row), kind);
        }
    }
    return picture;
}

QPixmap sideBySide(const HardCasePicture &picture, const QSize &size, const QPalette &palette,
                   double devicePixelRatio)
{
    QPixmap pixmap(size * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    if (picture.drawn.isNull())
        return pixmap;
    constexpr int gap = 4;
    QPainter painter(&pixmap);
    const int cell = std::max(1,
                              std::min((size.width() - gap) / 2 / picture.drawn.width(),
                                       size.height() / picture.drawn.height()));
    const QSize part = picture.drawn.size() * cell;
    const int half = (size.width() - gap) / 2;
    const QPoint left((half - part.width()) / 2, (size.height() - part.height()) / 2);
    const QPoint right = left + QPoint(half + gap, 0);
    painter.drawImage(QRect(left, part), picture.drawn);
    painter.drawImage(QRect(right, part), picture.truth);
    if (cell >= leastOutlinedCell) {
        paintEdges(painter, picture.edges, QRect(left, part), cell, palette);
        paintEdges(painter, picture.edges, QRect(right, part), cell, palette);
    }
    for (const auto &[at, kind] : picture.marks)
        paintDifference(painter, QRectF(left + at * cell, QSizeF(cell, cell)), kind, palette);
    return pixmap;
}

struct HardCasesVerdicts::Row {
    const Method *method = nullptr;
    std::map<Arithmetic, Cell> cells = {};
    Cell cell(Arithmetic arithmetic) const
    {
        const auto found = cells.find(arithmetic);
        return found == cells.end() ? Cell() : found->second;
    }
};

HardCasesVerdicts::HardCasesVerdicts(QWidget *parent)
    : QTableView(parent)
{
    named(this, "hardCaseVerdicts", tr("How each method handles this case"));
    std::vector<RowsColumn<Row>> columns
        = {{tr("method"),
            {},
            [](const Row &row) { return methodTitle(*row.method); },
            Qt::AlignLeft,
            [](const Row &row, int role) {
                return role == Qt::ToolTipRole ? QVariant(methodSummary(*row.method)) : QVariant();
            }}};
    for (const Arithmetic arithmetic : allArithmetics)
        columns.push_back(
            {QString::fromUtf8(nameOf(arithmetic)),
             {},
             [arithmetic](const Row &row) {
                 return row.method->supports(arithmetic) ? row.cell(arithmetic).text() : QString();
             },
             Qt::AlignHCenter,
             [table = static_cast<QTableView *>(this), arithmetic](const Row &row, int role) {
                 if (role == Qt::ToolTipRole)
                     return QVariant(row.method->supports(arithmetic)
                                         ? row.cell(arithmetic).toolTip()
                                         : tr("the method does not compute in it"));
                 return role == Qt::ForegroundRole && row.cell(arithmetic).fellShort > 0
                     ? QVariant(signColour(Sign::Extra, table->palette()))
                     : QVariant();
             }});
    setModel(m_rows = new RowsModel<Row>(std::move(columns), this));
    setSelectionMode(QAbstractItemView::NoSelection);
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    setMinimumHeight(160);
}

void HardCasesVerdicts::show(const std::vector<ContenderVerdict> &verdicts)
{
    std::vector<Row> rows;
    for (const ContenderVerdict &verdict : verdicts) {
        const Method *method = verdict.contender.method;
        if (rows.empty() || rows.back().method != method)
            rows.push_back({method});
        rows.back().cells[verdict.contender.settings.arithmetic].add(verdict);
    }
    m_rows->setRows(std::move(rows));
}

} // namespace pixelplumb
