// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/methodmenu.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/corewords.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

#include <QActionGroup>
#include <QMap>

namespace pixelplumb {

namespace {

/// Greys an action that the method refuses, with its objection.
void setObjection(QAction *action, const QString &objection)
{
    action->setEnabled(objection.isEmpty());
    action->setToolTip(objection.isEmpty()
                           ? action->text()
                           : MethodMenu::tr("The method %1").arg(withTitles(objection)));
}

} // namespace

MethodMenu::MethodMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Method"), window)
    , m_document(parts.document)
{
    setObjectName(QStringLiteral("methodMenu"));
    setToolTipsVisible(true);
    addMethods(parts.canvas);
    addSeparator();
    greyWhereIdle(
        addSettings("arithmeticMenu", tr("&Arithmetic"), allArithmetics, &ScanSettings::arithmetic),
        DrawingSetting::Arithmetic);
    greyWhereIdle(
        addSettings("fillRuleMenu", tr("&Fill rule"), allFillRules, &ScanSettings::fillRule),
        DrawingSetting::FillRule);
    greyWhereIdle(
        addSettings("roundingMenu", tr("&Rounding"), allByteRoundings, &ScanSettings::rounding),
        DrawingSetting::Rounding);
    addVariants();
}

void MethodMenu::addVariants()
{
    QMenu *menu = addMenu(tr("Misprints and &typical mistakes"));
    menu->setObjectName(QStringLiteral("variantMenu"));
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
        action->setObjectName(QStringLiteral("variant-") + nameText(nameOf(variant)));
        action->setCheckable(true);
        const auto update = [this, action, variant] {
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
        };
        connect(m_document, &SceneDocument::sceneChanged, action, update);
        update();
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
        QAction *action = addMenuAction(family, "", methodTitle(method), key,
                                        [this, id] { m_document->setMethod(id); });
        action->setObjectName(QStringLiteral("method-") + method.id);
        action->setCheckable(true);
        group->addAction(action);
        confineKeyTo(canvas, action);
        const auto update = [this, action, id] {
            const Scene &scene = m_document->scene();
            action->setChecked(scene.method == id);
        };
        action->setToolTip(methodSummary(method));
        connect(m_document, &SceneDocument::sceneChanged, action, update);
        update();
    }
}

/// Greys the menu where no other choice would change anything, with the reason.
void MethodMenu::greyWhereIdle(QMenu *menu, DrawingSetting setting)
{
    QAction *entry = menu->menuAction();
    const auto update = [this, entry, setting] {
        const QString reason = idleReason(setting, m_document->scene());
        entry->setEnabled(reason.isEmpty());
        entry->setToolTip(reason.isEmpty() ? entry->text()
                                           : tr("The method %1").arg(withTitles(reason)));
    };
    connect(m_document, &SceneDocument::sceneChanged, entry, update);
    update();
}

template <class Choices, class Member>
QMenu *MethodMenu::addSettings(const char *name, const QString &title, const Choices &choices,
                               Member member)
{
    QMenu *menu = addMenu(title);
    menu->setObjectName(QLatin1String(name));
    menu->setToolTipsVisible(true);
    auto *group = new QActionGroup(menu);
    for (const auto choice : choices) {
        const std::string_view text = nameOf(choice);
        QAction *action
            = addMenuAction(menu, "", QString::fromUtf8(text.data(), qsizetype(text.size())), {},
                            [this, choice, member] {
                                ScanSettings settings = m_document->scene().settings;
                                settings.*member = choice;
                                m_document->setSettings(settings);
                            });
        action->setObjectName(menu->objectName() + QLatin1Char('-') + action->text());
        action->setCheckable(true);
        group->addAction(action);
        const auto update = [this, action, choice, member] {
            const Scene &scene = m_document->scene();
            ScanSettings settings = scene.settings;
            action->setChecked(settings.*member == choice);
            settings.*member = choice;
            const Method *method = methodNamed(QString::fromStdString(scene.method));
            setObjection(action, method ? method->objection(settings) : QString());
        };
        connect(m_document, &SceneDocument::sceneChanged, action, update);
        update();
    }
    return menu;
}

} // namespace pixelplumb
