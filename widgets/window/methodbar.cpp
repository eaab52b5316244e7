// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/methodbar.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/corewords.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/methodbox.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

namespace pixelplumb {

namespace {

/// Characters of a method's title that fit into the bar in a window of 1024 pixels; longer titles
/// are elided in the middle there. The list shows whole titles.
constexpr int shownTitleLength = 15;

QString methodNote(const QString &text)
{
    return MethodBar::tr("The method %1").arg(withTitles(text));
}

/// Greys an entry that the method refuses, with its objection.
void setObjection(QComboBox *box, int row, const QString &objection, const QString &meaning)
{
    auto *model = qobject_cast<QStandardItemModel *>(box->model());
    QStandardItem *item = model->item(row);
    item->setEnabled(objection.isEmpty());
    item->setToolTip(toolTipHtml({objection.isEmpty() ? meaning : methodNote(objection)}));
}

QString meaningOf(Arithmetic arithmetic)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        return MethodBar::tr("Integer quotient and remainder: nothing is rounded before the byte");
    case Arithmetic::Float32:
        return MethodBar::tr("Binary floating point, 24 bits of precision");
    case Arithmetic::Float64:
        return MethodBar::tr("Binary floating point, 53 bits of precision");
    case Arithmetic::Fixed16:
        return MethodBar::tr("Fixed point in 32 bits, 16 after the point");
    case Arithmetic::Fixed32:
        return MethodBar::tr("Fixed point in 64 bits, 32 after the point");
    }
    return {};
}

QString meaningOf(FillRule rule)
{
    switch (rule) {
    case FillRule::Closed:
        return MethodBar::tr("A sample on an edge belongs to the triangle: ⌈y_B⌉ … ⌊y_T⌋");
    case FillRule::HalfOpenColumn:
        return MethodBar::tr("Watertight: ⌈y_B⌉ … ⌈y_T⌉−1, columns ⌈x₀⌉ … ⌈x₂⌉−1");
    case FillRule::TopLeft:
        return MethodBar::tr("A sample on a top or left edge belongs to the triangle (Direct3D)");
    case FillRule::OffScreenPoint:
        return MethodBar::tr("A sample on an edge belongs to the side of an off-screen point");
    case FillRule::Open:
        return MethodBar::tr("A sample on an edge belongs to neither side: ⌊y_B⌋+1 … ⌈y_T⌉−1");
    }
    return {};
}

QString meaningOf(ByteRounding rounding)
{
    switch (rounding) {
    case ByteRounding::Nearest:
        return MethodBar::tr("The byte of a colour level v is ⌊v + ½⌋");
    case ByteRounding::Truncate:
        return MethodBar::tr("The byte of a colour level v is ⌊v⌋");
    }
    return {};
}

/// Shows all values of a setting in its box, says which ones the method refuses, and greys the box
/// where none of them would change anything.
template <class Choices, class Choice>
void showChoices(const MethodBar::Setting &shown, const Choices &choices, const Scene &scene,
                 Choice ScanSettings::*member)
{
    QComboBox *box = shown.box;
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    const ScanSettings &settings = scene.settings;
    const QString idle = idleReason(shown.setting, scene);
    box->setEnabled(idle.isEmpty());
    box->setToolTip(idle.isEmpty() ? shown.meaning : methodNote(idle));
    for (int row = 0; row < int(choices.size()); ++row) {
        ScanSettings chosen = settings;
        chosen.*member = choices[std::size_t(row)];
        setObjection(box, row, method ? method->objection(chosen) : QString(),
                     meaningOf(choices[std::size_t(row)]));
        if (choices[std::size_t(row)] == settings.*member)
            box->setCurrentIndex(row);
    }
}

/// Greys an action that the method refuses, with its objection.
void setObjection(QAction *action, const QString &objection)
{
    action->setEnabled(objection.isEmpty());
    action->setToolTip(objection.isEmpty()
                           ? action->text()
                           : MethodMenu::tr("The method %1").arg(withTitles(objection)));
}

} // namespace

MethodBar::MethodBar(SceneDocument *document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_layout(new QHBoxLayout(this))
    , m_method(new MethodBox(this))
{
    setObjectName(u"methodBar"_s);
    m_layout->setContentsMargins(8, 0, 0, 0);
    m_layout->setSpacing(6);
    m_layout->addWidget(m_method); // without a label: a method's title is clear by itself
    named(m_method, "methodBox", tr("Method"));
    m_method->setMinimumContentsLength(shownTitleLength);
    connect(m_method, &QComboBox::activated, this, [this](int row) {
        m_document->setMethod(m_method->itemData(row).toString().toStdString());
    });
    m_arithmetic = addSetting(DrawingSetting::Arithmetic, u"arithmeticBox"_s, tr("Arithmetic"),
                              tr("What the increments are computed in"));
    m_fillRule = addSetting(DrawingSetting::FillRule, u"fillRuleBox"_s, tr("Fill rule"),
                            tr("Which side owns a sample that lies exactly on an edge"));
    m_rounding = addSetting(DrawingSetting::Rounding, u"roundingBox"_s, tr("Rounding"),
                            tr("How a colour level becomes a byte"));
    addSettings();
    connect(document, &SceneDocument::sceneChanged, this, &MethodBar::followScene);
    followScene();
}

MethodBar::Setting MethodBar::addSetting(DrawingSetting setting, const QString &name,
                                         const QString &label, const QString &meaning)
{
    auto *box = new ElidingBox(this);
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setToolTip(meaning);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto *text = new QLabel(label, this);
    text->setBuddy(box);
    m_layout->addSpacing(4);
    m_layout->addWidget(text);
    m_layout->addWidget(box);
    return {setting, box, meaning};
}

void MethodBar::addSettings()
{
    const auto fill = [this](QComboBox *box, const auto &choices, auto member) {
        for (const auto choice : choices)
            box->addItem(coreWord(nameOf(choice)));
        connect(box, &QComboBox::activated, this, [this, choices, member](int row) {
            ScanSettings settings = m_document->scene().settings;
            settings.*member = choices[std::size_t(row)];
            m_document->setSettings(settings);
        });
    };
    fill(m_arithmetic.box, allArithmetics, &ScanSettings::arithmetic);
    fill(m_fillRule.box, allFillRules, &ScanSettings::fillRule);
    fill(m_rounding.box, allByteRoundings, &ScanSettings::rounding);
}

void MethodBar::followScene()
{
    const Scene &scene = m_document->scene();
    const Method *chosen = methodNamed(QString::fromStdString(scene.method));
    m_method->setCurrentIndex(m_method->findData(QString::fromStdString(scene.method)));
    m_method->setToolTip(chosen ? methodTitle(*chosen) + u'\n' + methodSummary(*chosen)
                                : QString());
    showChoices(m_arithmetic, allArithmetics, scene, &ScanSettings::arithmetic);
    showChoices(m_fillRule, allFillRules, scene, &ScanSettings::fillRule);
    showChoices(m_rounding, allByteRoundings, scene, &ScanSettings::rounding);
}

MethodMenu::MethodMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Method"), window)
    , m_document(parts.document)
{
    setObjectName(u"methodMenu"_s);
    setToolTipsVisible(true);
    addMethods(parts.canvas);
    addSeparator();
    addVariants();
}

void MethodMenu::addVariants()
{
    QMenu *menu = addMenu(tr("Misprints and &typical mistakes"));
    menu->setObjectName(u"variantMenu"_s);
    menu->setToolTipsVisible(true);
    for (const Variant variant : allVariants) {
        const QString title = nameText(wordsOf(variant, SpanAxis::Free).title);
        QAction *action = addMenuAction(menu, "", title, {}, [this, variant] {
            ScanSettings settings = m_document->scene().settings;
            settings.variants = settings.variants.contains(variant)
                ? settings.variants.without(variant)
                : settings.variants.with(variant);
            m_document->setSettings(settings);
        });
        action->setObjectName(u"variant-"_s + nameText(nameOf(variant)));
        action->setCheckable(true);
        keepUpdated(m_document, &SceneDocument::sceneChanged, action, [this, action, variant] {
            const Scene &scene = m_document->scene();
            const Method *method = methodNamed(QString::fromStdString(scene.method));
            ScanSettings settings = scene.settings;
            action->setChecked(settings.variants.contains(variant));
            settings.variants = VariantSet().with(variant);
            setObjection(action, method ? method->objection(settings) : QString());
            if (!method || !action->isEnabled())
                return;
            const VariantWords &words = wordsOf(variant, method->spanAxis);
            action->setToolTip(tr("%1, in place of %2. %3\n%4")
                                   .arg(nameText(words.printed), nameText(words.right),
                                        nameText(words.fault), nameText(words.source)));
        });
    }
}

void MethodMenu::addMethods(Canvas *canvas)
{
    auto *group = new QActionGroup(this);
    int digit = 0;
    QMap<MethodFamily, QMenu *> families; // a single menu would be higher than a screen
    for (const Method &method : methods()) {
        QMenu *&family = families[method.family];
        if (!family) {
            family = addMenu(coreWord(titleOf(method.family)));
            family->setToolTipsVisible(true);
        }
        const std::string id = method.id.toStdString();
        const QKeySequence key = ++digit <= 9 ? QKeySequence(Qt::Key_0 + digit) : QKeySequence();
        QAction *action = addSwitch(
            family, "", methodTitle(method), key, [this, id] { m_document->setMethod(id); },
            m_document, &SceneDocument::sceneChanged,
            [this, id] { return m_document->scene().method == id; });
        action->setObjectName(u"method-"_s + method.id);
        group->addAction(action);
        confineKeyTo(canvas, action);
        action->setToolTip(methodSummary(method));
    }
}

} // namespace pixelplumb
