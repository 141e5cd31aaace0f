package robotran.ui.learning

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableLongStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameMillis
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.ui.school.tags.LearningTags
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawSheet
import robotran.ui.sheet.paperGrain
import robotran.uikit.*
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * A sheet on which a robot draws what a pupil may try, with the command that it is at. It draws each picture once and
 * then rests; with less motion a finished picture is there from the beginning. Screen readers pass it by: it shows what
 * the page says.
 */
@Composable
internal fun WelcomeSheet(modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val isStill = LocalLessMotion.current
    var shown by remember { mutableLongStateOf(0) }
    LaunchedEffect(isStill) {
        if (isStill) return@LaunchedEffect
        val begin = withFrameMillis { it }
        while (shown < SHOW) withFrameMillis { shown = (it - begin).coerceAtMost(SHOW) }
    }
    val (drive, milliseconds) = if (isStill) STILL to STILL.duration else momentOf(shown)
    val moment = drive.at(milliseconds)
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val grain = remember(colours) { if (colours.isHighContrast) null else paperGrain(colours.paper) }
    val fit = remember { SheetFit(SHEET, MARGIN) }
    BoxWithConstraints(
        modifier.clipToBounds().background(colours.desk).testTag(LearningTags.WELCOME_SHEET).clearAndSetSemantics { },
    ) {
        val density = LocalDensity.current
        val label = COMMAND_HEIGHT * density.fontScale
        val hasLabel = maxHeight >= label * MIN_HEIGHT
        val below = with(density) { if (hasLabel) label.toPx() else 0f }
        val paper = fit.into(Size(constraints.maxWidth.toFloat(), constraints.maxHeight - below)).transform.paper
        Canvas(Modifier.fillMaxSize()) {
            val drawing = fit.into(Size(size.width, size.height - below))
            drawSheet(drawing, stateOf(moment, milliseconds), sheetColours, grain = grain, isStill = isStill)
        }
        if (hasLabel) moment.command?.let { Command(it.text, with(density) { paper.bottom.toDp() }) }
    }
}

/** The command that the robot is at, below the paper. */
@Composable
private fun BoxScope.Command(text: String, paperBottom: Dp) = Text(
    text,
    Modifier
        .align(Alignment.TopCenter)
        .padding(top = paperBottom + Space.SMALL)
        .background(LocalRobotranColours.current.pane, Shapes.SMALL)
        .padding(horizontal = Space.MEDIUM, vertical = Space.TINY),
    codeStyle(),
    maxLines = 1,
)

/** The drive that is shown at [shown], and how long it has lasted. */
private fun momentOf(shown: Long): Pair<WelcomeDrive, Long> {
    var rest = shown
    for (drive in WelcomeDrive.ALL.dropLast(1)) {
        if (rest < drive.duration + PAUSE) return drive to rest
        rest -= drive.duration + PAUSE
    }
    return WelcomeDrive.ALL.last() to rest
}

private fun stateOf(moment: WelcomeMoment, milliseconds: Long): SessionState {
    val motors = BRICK.motors.mapIndexed { port, motor ->
        val mode = when (moment.command) {
            null -> MotorMode.BRAKE
            is WelcomeCommand.Forward -> MotorMode.FORWARD
            is WelcomeCommand.TurnLeft -> if (port == 0) MotorMode.BACKWARD else MotorMode.FORWARD
        }
        motor.copy(mode = mode)
    }
    val brick = BRICK.copy(motors = motors, run = if (moment.command == null) RunState.Idle else RunState.Running(0))
    return SessionState(
        milliseconds,
        listOf(RobotSnapshot(brick, moment.robot, bumps = 0, warnings = emptyList(), romCalls = 0)),
        blocks = emptyList(),
        lamps = emptyList(),
        ink = Ink(listOf(InkStroke(moment.line)), 0.0),
        goals = emptyList(),
    )
}

private val BRICK = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state
private val STILL = WelcomeDrive.ALL[1]
private val SHEET = World(
    "",
    Paper(WelcomeDrive.WIDTH, WelcomeDrive.HEIGHT),
    listOf(RobotPlacement(WelcomeDrive.ALL.first().at(0).robot.pose)),
)

/** The height of the command with the gap above it, at default font size. */
private val COMMAND_HEIGHT = 40.dp

/** From this multiple of it on, there is room for it. */
private const val MIN_HEIGHT = 5

/** The desk around the paper, in centimetres. */
private const val MARGIN = 3.0

/** How long a finished picture can be seen before the next one begins, in milliseconds. */
private const val PAUSE = 1_500L

/** How long all of it takes. */
private val SHOW = WelcomeDrive.ALL.sumOf { it.duration } + PAUSE * (WelcomeDrive.ALL.size - 1)
