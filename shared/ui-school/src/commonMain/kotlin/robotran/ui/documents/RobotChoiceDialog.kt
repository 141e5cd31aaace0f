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
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.text
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.editing.RobotTexts
import robotran.simulation.state.RobotState
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.ExportTexts
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
import kotlin.math.max

/**
 * "Which robot do you have?": a picture of the ready robot with each brick, which begins a project with it. A board has
 * a second question: which buggy carries it.
 *
 * @param board the one whose buggy is asked for; null for the first question.
 */
@Composable
internal fun RobotChoiceDialog(board: BrickKind?, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        if (board == null) HubTexts.whichRobot(spoken) else HubTexts.whichBuggy(spoken),
        close,
        buttons = {
            if (board != null) {
                Button(ExportTexts.back(spoken), DocumentTags.ROBOT_BACK, ButtonKind.DIALOG_OTHER) {
                    onEvent(DocumentEvent.RobotChoiceRequested)
                }
            }
            Button(DocumentTexts.cancel(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
        },
    ) {
        if (board == null) Bricks(onEvent) else Buggies(board, onEvent)
    }
}

@Composable
private fun Bricks(onEvent: (DocumentEvent) -> Unit) = Cards {
    for (brick in BrickKind.entries) {
        val robot = ReadyRobots.defaultOf(brick)
        RobotCard(robot, HubTexts.robotWith(spoken, brick), DocumentTags.robot(brick)) {
            onEvent(
                if (brick.isOnBuggy) DocumentEvent.BuggyChoiceRequested(brick) else DocumentEvent.NewWithBrick(brick),
            )
        }
    }
}

@Composable
private fun Buggies(board: BrickKind, onEvent: (DocumentEvent) -> Unit) = Cards {
    for (buggy in BuggyKind.entries) {
        val name = if (buggy == BuggyKind.PLAIN) RobotTexts.readyPlainBuggy(spoken) else buggy.label
        RobotCard(ReadyRobots.on(buggy, board), name, DocumentTags.robot(buggy)) {
            onEvent(DocumentEvent.NewWithBrick(board, buggy))
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Cards(content: @Composable () -> Unit) = FlowRow(
    Modifier.fillMaxWidth(),
    Arrangement.spacedBy(Space.MEDIUM),
    Arrangement.spacedBy(Space.MEDIUM),
) { content() }

@Composable
private fun RobotCard(robot: RobotDescription, name: String, tag: String, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    // The longest words of names have room in large text, too.
    val width = CARD_WIDTH * max(LocalDensity.current.fontScale, 1f)
    CardButton(tag, onClick, Modifier.width(width)) {
        Column {
            RobotFromAbove(robot, Modifier.fillMaxWidth().height(PICTURE_HEIGHT).background(colours.paper))
            Text(
                breakable(name),
                Modifier.heightIn(min = WORDS_HEIGHT).padding(Space.SMALL)
                    .clearAndSetSemantics { text = AnnotatedString(name) },
                style = TextStyles.label,
            )
        }
    }
}

/**
 * [name] with a place for a line's end before a colon that begins a word, as in "Kitronik :MOVE Motor": the rules of Unicode
 * allow none there, so a narrow line would end within the word.
 */
private fun breakable(name: String): String = name.replace(" :", " $ZERO_WIDTH_SPACE:")

private const val ZERO_WIDTH_SPACE = '\u200B'

/** The [robot], looking up. */
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
