package robotran.ui.documents

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.editing.RobotTexts
import robotran.simulation.state.RobotState
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.sheet.CanvasTarget
import robotran.ui.sheet.RobotPlan
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.drawRobot
import robotran.ui.texts.HubTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.geometry.Pose

/** "Which robot do you have?": a picture of the ready robot with each brick, which begins a project with it. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RobotChoiceDialog(onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        HubTexts.whichRobot(spoken),
        close,
        buttons = {
            Button(DocumentTexts.cancel(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
        },
    ) {
        FlowRow(
            Modifier.fillMaxWidth(),
            Arrangement.spacedBy(Space.MEDIUM),
            Arrangement.spacedBy(Space.MEDIUM),
        ) {
            for (brick in BrickKind.entries) {
                val robot = ReadyRobots.defaultOf(brick)
                RobotCard(robot, DocumentTags.robot(brick)) { onEvent(DocumentEvent.NewWithBrick(brick)) }
                if (brick != BrickKind.entries.first { it.isOnBuggy }) continue
                for (buggy in BuggyKind.entries.filter { it != robot.buggy?.kind }) {
                    RobotCard(ReadyRobots.on(buggy), DocumentTags.robot(buggy)) {
                        onEvent(DocumentEvent.NewWithBrick(brick, buggy))
                    }
                }
            }
        }
    }
}

@Composable
private fun RobotCard(robot: RobotDescription, tag: String, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    CardButton(tag, onClick, Modifier.width(CARD_WIDTH)) {
        Column {
            RobotFromAbove(robot, Modifier.fillMaxWidth().height(PICTURE_HEIGHT).background(colours.paper))
            Text(
                nameOf(robot),
                Modifier.heightIn(min = WORDS_HEIGHT).padding(Space.SMALL),
                style = TextStyles.label,
            )
        }
    }
}

/** Its brick and, on a micro:bit, its buggy. */
@Composable
private fun nameOf(robot: RobotDescription): String {
    val buggy = robot.buggy?.kind
    val brick = HubTexts.robotWith(spoken, robot.brick)
    return when (buggy) {
        null -> brick
        BuggyKind.PLAIN -> RobotTexts.readyPlainBuggy(spoken)
        else -> "$brick, ${buggy.label}"
    }
}

/** The ready robot, looking up. */
@Composable
private fun RobotFromAbove(robot: RobotDescription, modifier: Modifier) {
    val plan = remember(robot) { RobotPlan(robot) }
    Canvas(modifier) {
        val scale = size.height / SHOWN_CENTIMETRES
        val middle = Rect(size.width / 2, 0f, size.width / 2, size.height / 2 + MIDDLE_CENTIMETRES * scale)
        val place = RobotPlacement(STANDING.pose, description = robot)
        CanvasTarget(this).drawRobot(STANDING, place, plan, SheetTransform(scale, middle), hasEyes = false)
    }
}

private val STANDING = RobotState(
    Pose(0.0, 0.0, 90.0),
    0.0,
    0.0,
    penDown = false,
    leftBumperPressed = false,
    rightBumperPressed = false,
)
private val CARD_WIDTH = 128.dp
private val PICTURE_HEIGHT = 112.dp
private val WORDS_HEIGHT = 68.dp

/** How much of the sheet a picture shows from top to bottom, and how far its middle is ahead of the wheels. */
private const val SHOWN_CENTIMETRES = 22f
private const val MIDDLE_CENTIMETRES = 0.8f
