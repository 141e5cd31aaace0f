package robotran.ui.robot

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.elementOf
import robotran.robotediting.elements
import robotran.ui.parts.readyRobotWithBrick
import robotran.ui.texts.RobotTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.ui.worldedit.FieldPanel
import robotran.ui.worldedit.HelpText
import robotran.ui.worldedit.RowHeading
import robotran.ui.worldedit.TextRow
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent
import robotran.world.ReadyRobots
import robotran.world.RobotLimits
import robotran.world.messages.sentence

/** The tabs of the workbench's panel. */
internal enum class RobotTab(val title: Label) {
    CHOSEN(RobotTexts::tabChosen),
    PARTS(RobotTexts::tabParts),
    ROBOT(RobotTexts::tabRobot),
}

/** @param tab null if none is open. */
@Composable
internal fun RobotTabs(tab: RobotTab?, onChoose: (RobotTab) -> Unit) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(colours.pane)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .selectableGroup(),
        Arrangement.spacedBy(4.dp),
    ) {
        for (each in RobotTab.entries) {
            val isOpen = each == tab
            Column(
                Modifier
                    .testTag("tab-robot-${each.name.lowercase()}")
                    .defaultMinSize(88.dp, Dimensions.TARGET)
                    .broughtIntoSight(isOpen)
                    .focusRing()
                    .selectable(isOpen, role = Role.Tab) { onChoose(each) }
                    .width(IntrinsicSize.Max)
                    .padding(horizontal = 12.dp),
                Arrangement.Center,
                Alignment.CenterHorizontally,
            ) {
                Text(
                    each.title(spoken),
                    Modifier.padding(top = 12.dp, bottom = 8.dp),
                    TextStyles.compact.strong,
                    color = if (isOpen) colours.onPane else colours.quiet,
                    maxLines = 1,
                )
                Box(Modifier.fillMaxWidth().height(3.dp).background(if (isOpen) colours.onPane else Color.Transparent))
            }
        }
    }
    HorizontalDivider()
}

@Composable
internal fun RobotPanel(scope: RobotScope, tab: RobotTab, onTab: (RobotTab) -> Unit, modifier: Modifier = Modifier) {
    val chosen = scope.editing.chosen
    val language = LocalLanguage.current
    val errors = scope.editing.errors.filter { tab == RobotTab.CHOSEN && scope.robot.elementOf(it) == chosen }
    key(tab, if (tab == RobotTab.CHOSEN) chosen else null) {
        FieldPanel("robot-panel", errors.map { it.sentence(language) }, "robot-chosen-trouble", modifier) {
            when (tab) {
                RobotTab.CHOSEN -> if (chosen == null) {
                    HelpText(RobotTexts.chooseFirst(spoken))
                } else {
                    ChosenElement(scope, chosen)
                }

                RobotTab.PARTS -> PartsPanel(scope) { onTab(RobotTab.CHOSEN) }
                RobotTab.ROBOT -> WholeRobotPanel(scope)
            }
        }
    }
}

@Composable
private fun ChosenElement(scope: RobotScope, chosen: RobotElement) {
    Text(
        robotElementText(scope.robot, chosen),
        Modifier.testTag("robot-chosen-name").heading(),
        TextStyles.lead.strong,
    )
    RobotElementActions(scope, chosen)
    HorizontalDivider()
    RobotElementFields(scope, chosen)
}

/** A list of all elements, for choosing without seeing or pointing. */
@Composable
private fun PartsPanel(scope: RobotScope, onChosen: () -> Unit) {
    val colours = LocalRobotranColours.current
    HelpText(RobotTexts.partsHelp(spoken))
    scope.robot.elements().forEachIndexed { row, element ->
        val isChosen = element == scope.editing.chosen
        Row(
            Modifier
                .fillMaxWidth()
                .testTag("robot-element-$row")
                .defaultMinSize(minHeight = Dimensions.TARGET)
                .focusRing()
                .clip(Shapes.MEDIUM)
                .background(if (isChosen) colours.runningLine else Color.Transparent)
                .selectable(isChosen, role = Role.Button) {
                    scope.make(RobotEdit.Choose(element))
                    onChosen()
                }
                .padding(horizontal = 12.dp),
            Arrangement.spacedBy(8.dp),
            Alignment.CenterVertically,
        ) {
            Text(robotElementText(scope.robot, element), Modifier.weight(1f), TextStyles.body)
            if (scope.editing.errors.any { scope.robot.elementOf(it) == element }) {
                IconView(EditIcons.WARNING, colours.error, size = 22.dp)
            }
        }
    }
}

/** The name, the brick, other robots, and files. */
@Composable
private fun WholeRobotPanel(scope: RobotScope) {
    val robot = scope.robot
    TextRow(
        WorldEditorTexts.name(spoken),
        robot.title,
        RobotLimits.MAXIMUM_TITLE_CHARACTERS,
        "robot-title",
        { scope.change(robot.copy(title = it), "title") },
        scope::settle,
    )
    ChipRow(
        RobotTexts.brick(spoken),
        BrickKind.entries.map { it to it.name },
        robot.brick,
        "robot-brick",
    ) { brick ->
        if (brick != robot.brick) {
            scope.changeAtOnce(robot.copy(brick = brick, base = ReadyRobots.defaultOf(brick).base))
        }
    }
    RowHeading(RobotTexts.ready(spoken))
    HelpText(RobotTexts.readyHelp(spoken))
    for ((name, ready) in ReadyRobots.all) {
        WordButton(
            readyRobotWithBrick(name),
            "robot-ready-$name",
            { scope.make(RobotEdit.Replace(ready)) },
            Modifier.fillMaxWidth(),
        )
    }
    HorizontalDivider(Modifier.padding(vertical = 8.dp))
    WordButton(
        RobotTexts.open(spoken),
        "robot-open",
        { scope.perform(RobotEditEvent.OpenRequested) },
        Modifier.fillMaxWidth(),
    )
    WordButton(
        RobotTexts.save(spoken),
        "robot-save",
        { scope.perform(RobotEditEvent.SaveRequested) },
        Modifier.fillMaxWidth(),
    )
}
