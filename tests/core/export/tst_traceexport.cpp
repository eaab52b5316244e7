// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/traceexport.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/tablefolder.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

namespace tst_traceexport {

using namespace pixelplumb;

namespace {

Scene defaultScene(Arithmetic arithmetic = Arithmetic::Exact)
{
    Scene scene = readSceneFile(resource(u"/scenes/default.json"_s))->scene;
    scene.settings.arithmetic = arithmetic;
    return scene;
}

QByteArray exported(const Scene &scene, TraceLevel level, TableFormat format)
{
    return exported(*traceScene(scene), {level, format});
}

/// The lines of a CSV, without their line ends.
QList<QByteArray> linesOf(const QByteArray &csv)
{
    QList<QByteArray> lines = QByteArray(csv).replace("\r\n", "\n").split('\n');
    lines.removeLast();
    return lines;
}

/// The nearest double of "277/54" or "17".
double valueOf(const QString &fraction)
{
    const QStringList parts = fraction.split(u'/');
    return parts[0].toDouble() / (parts.size() > 1 ? parts[1].toDouble() : 1);
}

/// The set of formulas by column name.
QMap<QString, QString> formulasOf(const Scene &scene, TraceLevel level)
{
    QMap<QString, QString> formulas;
    const auto document
        = QJsonDocument::fromJson(exported(scene, level, TableFormat::Json)).object();
    for (const QJsonValue &column : document[u"columns"_s].toArray())
        formulas[column[u"id"_s].toString()] = column[u"formula"_s].toString();
    return formulas;
}

Scene smallTriangle(const char *method, LatticePoint third = latticePixel(3, 7))
{
    Scene scene;
    scene.frame = frameOf(10, 10);
    scene.method = method;
    scene.triangles = {Triangle{{{{latticePixel(1, 1), {{255, 0, 0}}},
                                  {latticePixel(7, 3), {{0, 255, 0}}},
                                  {third, {{0, 0, 255}}}}}}};
    scene.settings = methodNamed(QString::fromLatin1(method))->adapted(scene.settings);
    return scene;
}

/// A device that is full after some bytes.
class FullDevice final : public QIODevice {
public:
    explicit FullDevice(qint64 room)
        : m_room(room)
    {
    }

protected:
    qint64 readData(char *, qint64) override { return -1; }
    qint64 writeData(const char *, qint64 size) override
    {
        m_room -= size;
        return m_room < 0 ? -1 : size;
    }

private:
    qint64 m_room;
};

} // namespace

/// The tables of a traced run: their rows, their columns and how they were calculated.
class TestTraceExport : public QObject {
    Q_OBJECT

private slots:
    void everyStageFromSpaceToTheFrameIsPrinted()
    {
        Scene scene = sceneOf({triangle3({0, 0, 2}, {1, 0, -2}, {0, 1, 4.5})});
        scene.triangles = defaultScene().triangles;

        const QList<QByteArray> lines
            = linesOf(exported(scene, TraceLevel::Stage, TableFormat::Csv));

        QCOMPARE(lines.value(0),
                 QByteArray("step,primitive,stage,point,used,used_exact,used_error,formula,numbers,"
                            "note"));
        const auto has = [&](const char *pattern) {
            const QRegularExpression expression(QString::fromUtf8(pattern));
            return std::ranges::any_of(lines, [&](const QByteArray &line) {
                return expression.match(QString::fromUtf8(line)).hasMatch();
            });
        };
        // First the triangle in the frame, then the two of the polygon that the near plane leaves.
        QVERIFY(!has("^\\d+,0,"));
        for (const char *pattern :
             {"^\\d+,1,Vertex,V₁,1,1,0,x,,$", "Camera,the camera,1,1,0,near,,$",
              "Clip coordinates,V₀,3,3,0,w = −z_view,−\\(−3\\),",
              "Clipped polygon,C₃,0\\.(8|7999)\\d*,0\\.8,.*,t = z_clip_V₀/\\(z_clip_V₀ − "
              "z_clip_V₂\\),.*,the near "
              "plane cuts V₀V₂$",
              "^\\d+,2,Lattice,C₃,.*,x = ⌊256·x′ \\+ ½⌋/256,"})
            QVERIFY2(has(pattern), pattern);
    }

    void writesARowForEachColumn()
    {
        const auto traced = traceScene(defaultScene());

        const QList<QByteArray> lines
            = linesOf(exported(defaultScene(), TraceLevel::Column, TableFormat::Csv));

        QCOMPARE(std::size_t(lines.size()), traced->trace->spanCount() + 1);
        QVERIFY(lines[0].startsWith("step,primitive,x,half,y_B,y_B_exact,y_B_error,y_T,"));
        // The edge (4, 5)–(58, 12) rises by 7/54 a column, (4, 5)–(53/2, 44) by 26/15.
        QVERIFY2(lines[2].startsWith(
                     "4,0,5,1,5.12962962962963,277/54,0,6.733333333333333,101/15,0,6,6,0,6,6,0,1,"),
                 lines[2].constData());
    }

    void writesARowForEachPixel()
    {
        const auto traced = traceScene(defaultScene());

        const QList<QByteArray> lines
            = linesOf(exported(defaultScene(), TraceLevel::Pixel, TableFormat::Csv));

        QCOMPARE(std::size_t(lines.size()), traced->trace->sampleCount() + 1);
        QCOMPARE(
            lines[0],
            QByteArray(
                "step,primitive,x,y,R,R_exact,R_error,R_level,R_byte,G,G_exact,G_error,G_level,"
                "G_byte,B,B_exact,B_error,B_level,B_byte,clamped,before,after,fate"));
        QCOMPARE(
            lines[1],
            QByteArray(
                "3,0,4,5,255,255,0,255,255,0,0,0,0,0,0,0,0,0,0,false,#000000,#ff0000,written"));
    }

    void givesEveryRowAsManyFieldsAsTheHeader_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<TraceLevel>("level");
        for (const Arithmetic arithmetic : allArithmetics) {
            QTest::addRow("%s, columns", nameOf(arithmetic).data())
                << arithmetic << TraceLevel::Column;
            QTest::addRow("%s, pixels", nameOf(arithmetic).data())
                << arithmetic << TraceLevel::Pixel;
        }
    }
    void givesEveryRowAsManyFieldsAsTheHeader()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(TraceLevel, level);

        const QList<QByteArray> lines
            = linesOf(exported(defaultScene(arithmetic), level, TableFormat::Csv));

        QVERIFY(lines.size() > 1);
        const auto commas = lines[0].count(',');
        for (const QByteArray &line : lines)
            QCOMPARE(line.count(','), commas);
    }

    void holdsNoErrorInExactArithmetic()
    {
        const QJsonDocument document = QJsonDocument::fromJson(
            exported(defaultScene(), TraceLevel::Pixel, TableFormat::Json));

        const QJsonArray rows = document[u"rows"_s].toArray();
        QVERIFY(!rows.isEmpty());
        for (const QJsonValue &row : rows) {
            QCOMPARE(row[u"R"_s].toDouble(-1), valueOf(row[u"R_exact"_s].toString()));
            QCOMPARE(row[u"R_error"_s].toDouble(-1), 0.0);
        }
    }

    void tellsTheErrorOfRoundedNumbers()
    {
        const QJsonDocument document = QJsonDocument::fromJson(
            exported(defaultScene(Arithmetic::Float32), TraceLevel::Column, TableFormat::Json));

        const QJsonValue row = document[u"rows"_s][1];
        QCOMPARE(row[u"y_B_exact"_s].toString(), u"277/54"_s);
        const float used = 5 + 7 / 54.0F;
        QCOMPARE(float(row[u"y_B"_s].toDouble()), used);
        const double error = double(used) - (5 + 7 / 54.0);
        QVERIFY(qAbs(row[u"y_B_error"_s].toDouble() - error) < 1e-14);
    }

    void saysInJsonHowTheTableWasMade()
    {
        const QJsonDocument document = QJsonDocument::fromJson(
            exported(defaultScene(Arithmetic::Fixed16), TraceLevel::Column, TableFormat::Json));

        QCOMPARE(document[u"pixelplumbTrace"_s].toInt(), 2);
        QCOMPARE(document[u"level"_s].toString(), u"column"_s);
        QCOMPARE(document[u"method"_s].toString(), u"column-scan"_s);
        QCOMPARE(document[u"arithmetic"_s].toString(), u"fixed16.16"_s);
        QCOMPARE(document[u"fillRule"_s].toString(), u"closed"_s);
        QCOMPARE(document[u"rounding"_s].toString(), u"nearest"_s);
        QCOMPARE(document[u"cut"_s].toBool(true), false);
        QCOMPARE(document[u"columns"_s].toArray().size(),
                 qsizetype(methodNamed(u"column-scan")->numbers.span.size()));
    }

    void givesAColumnOneJsonTypeInAllRows()
    {
        const QJsonDocument document = QJsonDocument::fromJson(
            exported(defaultScene(), TraceLevel::Column, TableFormat::Json));

        const QJsonArray rows = document[u"rows"_s].toArray();
        for (const QJsonValue &row : rows) {
            QVERIFY(row[u"x"_s].isDouble());
            QVERIFY(row[u"pixels"_s].isDouble());
            QVERIFY(row[u"y_B"_s].isDouble());
            QVERIFY(row[u"y_B_exact"_s].isString());
            QVERIFY(row[u"y_B_error"_s].isDouble());
        }
    }

    void writesAnEmptySceneAsATableWithoutRows()
    {
        Scene scene;

        QCOMPARE(linesOf(exported(scene, TraceLevel::Column, TableFormat::Csv)).size(),
                 qsizetype(1));
        const QJsonDocument document
            = QJsonDocument::fromJson(exported(scene, TraceLevel::Pixel, TableFormat::Json));
        QVERIFY(document[u"rows"_s].isArray());
        QVERIFY(document[u"rows"_s].toArray().isEmpty());
    }

    void givesTheFormulasByWhichTheRunComputed()
    {
        // Falls from (20, 44) to (30, 41): c = 2·3 − 2·10·44 − 2·3·20 − 10 = −1004.
        const Scene falling = sceneOf(lineAt(20, 44, 30, 41), "line-bresenham", frameOf(48, 48));
        QCOMPARE(formulasOf(falling, TraceLevel::SetUp)[u"c"_s],
                 u"c = 2Δy − 2·Δx·y₀ − 2Δy·x₀ − Δx"_s);
        QVERIFY(exported(falling, TraceLevel::SetUp, TableFormat::Csv).contains(",-1004"));
        const auto steps = formulasOf(falling, TraceLevel::Column);
        QCOMPARE(steps[u"y_line"_s], u"y_line = y₀ − (x_k + 1 − x₀)·Δy/Δx"_s);
        QCOMPARE(steps[u"d_lower"_s], u"d_lower = y_k − y_line"_s);
        QCOMPARE(steps[u"d_upper"_s], u"d_upper = y_line − (y_k − 1)"_s);

        // 4·4² px of x, 3 of y: p₀ = 9 − 16·3 + 4 = −35; for equal radii 5/4 − 4.
        const Scene ellipse
            = sceneOf(ellipseAtUnits(latticePixel(20, 20), 4 * unitsPerPixel, 3 * unitsPerPixel),
                      "circle-midpoint", frameOf(48, 48));
        QCOMPARE(formulasOf(ellipse, TraceLevel::SetUp)[u"p_0"_s],
                 u"p₀ = r_y² − r_x²·r_y + r_x²/4"_s);
        QVERIFY(exported(ellipse, TraceLevel::SetUp, TableFormat::Csv).contains(",-35"));
        QCOMPARE(formulasOf(sceneOf(circleAt(20, 20, 4), "circle-midpoint", frameOf(48, 48)),
                            TraceLevel::SetUp)[u"p_0"_s],
                 u"p₀ = 5/4 − r_x"_s);

        Scene varied = smallTriangle("column-scan");
        varied.settings.variants
            = VariantSet().with(Variant::DivisorMinusOne).with(Variant::NoColourPreStep);
        QCOMPARE(formulasOf(varied, TraceLevel::SetUp)[u"m_01"_s],
                 u"m₀₁ = (y₁ − y₀)/(x₁ − x₀ − 1)"_s);
        QVERIFY(!formulasOf(varied, TraceLevel::Pixel)[u"R"_s].contains(u'⌈'));

        // The line through (1, 1) and (3, 3) passes through (0, 0).
        const auto solved = formulasOf(smallTriangle("edge-equations-solved", latticePixel(3, 3)),
                                       TraceLevel::SetUp);
        int divided = 0;
        for (const char *id : {"a_0", "a_1", "a_2"})
            divided += solved[QString::fromLatin1(id)].contains(u"/q"_s) ? 1 : 0;
        QCOMPARE(divided, 2);

        const QString alongSegment = formulasOf(smallTriangle("edge-equations", latticePixel(4, 2)),
                                                TraceLevel::Pixel)[u"R"_s];
        QVERIFY2(alongSegment.contains(u"(x − x"_s), qPrintable(alongSegment));
    }

    /// The second triangle has one colour, which is neither carried nor divided.
    void levelsThatNoFormulaGivesAreTold()
    {
        Scene scene = smallTriangle("column-scan");
        scene.triangles.push_back({{{{latticePixel(2, 1), {{128, 128, 128}}},
                                     {latticePixel(9, 1), {{128, 128, 128}}},
                                     {latticePixel(8, 9), {{128, 128, 128}}}}}});
        scene.attributes.resize(2);
        for (std::size_t i = 0; i < 6; ++i)
            scene.attributes[i / 3].vertices[i % 3].w = Attribute(1 + i % 3) * attributeOne;
        scene.attributes[1].triangle = 1;
        QCOMPARE(formulasOf(scene, TraceLevel::Pixel)[u"R"_s],
                 u"R = R_w/q; other values by no formula of this list"_s);
    }

    /// All formulas of each number, and no formula that no step has.
    void givesTheFormulasThatTheStepsAreExplainedBy()
    {
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle))
                continue;
            const Scene scene = smallTriangle(method.id.toLatin1().constData());
            const auto traced = traceScene(scene);
            std::array<QSet<QString>, 3> told;
            for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
                for (const FormulaLine &line : explainStep(*traced, step).lines)
                    told[std::size_t(traced->trace->stepAt(step).kind)].insert(line.symbols);
            }
            int compared = 0;
            for (const auto &[level, kind] : {std::pair(TraceLevel::SetUp, StepKind::SetUp),
                                              std::pair(TraceLevel::Column, StepKind::Span),
                                              std::pair(TraceLevel::Pixel, StepKind::Sample)}) {
                const QSet<QString> &symbols = told[std::size_t(kind)];
                QSet<QString> written;
                for (const QString &formulas : formulasOf(scene, level)) {
                    for (const QString &formula : formulas.split(u"; "_s, Qt::SkipEmptyParts))
                        written.insert(formula);
                }
                for (const QString &formula : written)
                    QVERIFY2(symbols.contains(formula), qPrintable(method.id + u' ' + formula));
                if (level != TraceLevel::Pixel) // at that level bytes are shown too
                    QCOMPARE(written, symbols);
                compared += int(written.size());
            }
            QVERIFY2(compared > 3, qPrintable(method.id));
        }
    }

    void writesTheSameBytesEachTime()
    {
        const Scene scene = defaultScene(Arithmetic::Float64);

        QCOMPARE(exported(scene, TraceLevel::Pixel, TableFormat::Json),
                 exported(scene, TraceLevel::Pixel, TableFormat::Json));
    }

    void alignsDecimalsAtThePoint()
    {
        TraceExportOptions options;
        options.format = TableFormat::Text;
        options.textNumbers = TextNumbers::Decimal;
        options.columns = {u"x"_s, u"y_T"_s};

        const QByteArray bytes = exported(*traceScene(defaultScene()), options);
        QVERIFY(!bytes.isEmpty());

        const QList<QByteArray> lines = bytes.split('\n');
        QCOMPARE(lines[0], QByteArray(" x         y_T"));
        QCOMPARE(lines[1], QByteArray(" 4   5"));
        QCOMPARE(lines[2], QByteArray(" 5   6.733333…"));
        QCOMPARE(lines[8], QByteArray("11  17.133333…"));
    }

    /// Nearly level edges: from (0, 2) to (8192, 2 1/256), and from (0, −2) below 0.
    void decimalsPartANumberFromTheWholeOneNextToIt()
    {
        Scene scene;
        scene.frame = frameOf(2, 6, 1, -3);
        scene.method = "column-scan";
        const Lattice far = 8192 * unitsPerPixel;
        scene.triangles
            = {Triangle{{{{{0, 2 * unitsPerPixel}, {}},
                          {{far, 2 * unitsPerPixel + 1}, {}},
                          {{far, 5 * unitsPerPixel}, {}}}}},
               Triangle{{{{{0, 0}, {}}, {{far, -1}, {}}, {{far, 3 * unitsPerPixel}, {}}}}}};
        TraceExportOptions options;
        options.format = TableFormat::Text;
        options.textNumbers = TextNumbers::Decimal;
        options.columns = {u"y_B"_s, u"first_row"_s};

        const QByteArray bytes = exported(*traceScene(scene), options);
        QVERIFY(!bytes.isEmpty());

        // At x = 1 y_B = 2 + 1/2097152 = 2.000000476… and −1/2097152.
        const QList<QByteArray> lines = bytes.split('\n');
        QVERIFY2(lines[1].contains("2.0000004…") && lines[1].endsWith(" 3"), lines[1].constData());
        QVERIFY2(lines[3].contains("−0.0000004…") && lines[3].endsWith(" 0"), lines[3].constData());
        QVERIFY2(!bytes.contains("0.000000 "), bytes.constData());
        QVERIFY2(!bytes.contains('-'), bytes.constData());
    }

    void saysWhenTheDeviceIsFull()
    {
        const auto traced = traceScene(defaultScene());
        FullDevice device(2000);
        device.open(QIODevice::WriteOnly);

        QVERIFY(!exportTrace(*traced, {}, device));
    }

    void endsWhenProgressSaysSo()
    {
        const auto traced = traceScene(defaultScene());
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        int calls = 0;
        TraceExportOptions options;
        options.progress = [&](const JobProgress &) { return ++calls < 3; };

        QVERIFY(!exportTrace(*traced, options, buffer));
        QCOMPARE(calls, 3);
        QCOMPARE(linesOf(bytes).size(), qsizetype(3));
    }
};

PIXELPLUMB_TEST(TestTraceExport)

} // namespace tst_traceexport

#include "tst_traceexport.moc"
