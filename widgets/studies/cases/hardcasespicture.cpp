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
            remarks.append(verdict.contender.name() + u": "_s + verdict.remarks.join(u"; "_s));
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
            return u"·"_s;
        return fellShort == 0 ? u"✓"_s : u"✗"_s;
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
    return parts.isEmpty() ? CaseVerdict::tr("correct") : parts.join(u", "_s);
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
    picture.part = scene.frame;
    picture.part.firstColumn = placed(middle.x(), width, window.firstColumn, window.endColumn());
    picture.part.firstRow = placed(middle.y(), height, window.firstRow, window.endRow());
    picture.part.width = width;
    picture.part.height = height;
    const auto crop = [&picture](const WrittenFrame &written) {
        return pictureWith(picture.part, [&](const QPoint &at) {
            const bool isWritten = written.isWritten(at.x(), at.y());
            return packed(isWritten ? written.colourAt(at.x(), at.y()) : picture.part.background);
        });
    };
    picture.drawn = crop(drawn);
    picture.truth = crop(truth);
    for (const Triangle &triangle : run.primitives.triangles) {
        const auto &[a, b, c] = triangle.vertices;
        picture.outlines.push_back({a.position, b.position, c.position});
    }
    forEachPixel(picture.part, picture.drawn.rect(), [&](const QPoint &at) {
        const Difference kind = differenceAt(drawn, truth, at.x(), at.y());
        if (kind != Difference::None)
            picture.marks.emplace_back(at, kind);
    });
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
    const int half = (size.width() - gap) / 2;
    const auto paint = [&](const QImage &image, int left) {
        const QRectF view(left, 0, half, size.height());
        const ViewMapping mapping = ViewMapping::fitted(picture.part, view, devicePixelRatio);
        const QRect device = mapping.devicePicture();
        painter.setClipRect(view);
        painter.drawImage(QRectF(mapping.positionOfDevice(device.topLeft()),
                                 QSizeF(device.size()) / devicePixelRatio),
                          image);
        FramePainter frame(painter, mapping, palette, view);
        if (cellSideOf(mapping) >= leastOutlinedCell) {
            for (const std::array<LatticePoint, 3> &outline : picture.outlines)
                frame.drawOutline(outline, {});
        }
        return mapping;
    };
    paint(picture.truth, half + gap);
    const ViewMapping mapping = paint(picture.drawn, 0);
    for (const auto &[at, kind] : picture.marks)
        paintDifference(painter, mapping.cellOf(at), kind, palette);
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
