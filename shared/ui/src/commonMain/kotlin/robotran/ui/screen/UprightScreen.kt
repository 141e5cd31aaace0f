package robotran.ui.screen

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.offset
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.program.ProgramPane
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WorkshopState

/**
 * A tablet in portrait: the tutorial, if open, in a wide strip; below it the world, then the program, and at the bottom
 * the run bar.
 *
 * @param runBar the run bar.
 */
@Composable
internal fun UprightScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, runBar: @Composable () -> Unit) {
    val tutorial = state.learning.tutorial
    val keyboard = LocalKeyboardHeight.current
    val line = LocalRobotranColours.current.line
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val whole = maxHeight + keyboard
        // Above an on-screen keyboard there is room only for the program and part of the paper.
        val isTutorialOpen = tutorial != null && !tutorial.isFolded && keyboard == 0.dp
        val isLarge = LocalDensity.current.fontScale > LARGE
        val tutorialShare = if (isLarge) TUTORIAL_SHARE_LARGE else TUTORIAL_SHARE
        // With large text, what there is to say about a task needs room below its sheet.
        val hasTask = state.part { hasTask || world.goals.isNotEmpty() }
        val first = when {
            isLarge && (isTutorialOpen || hasTask) -> PROGRAM_SHARE_LARGE
            isTutorialOpen -> PROGRAM_SHARE_READING
            else -> PROGRAM_SHARE
        }
        Column(Modifier.fillMaxSize()) {
            TopStrip(state.document, state.worldEdit != null, state.fullPane, onEvent)
            HorizontalDivider(color = line)
            when {
                isTutorialOpen -> TutorialPane(
                    state.learning,
                    onEvent,
                    Modifier.fillMaxWidth().height(whole * tutorialShare),
                )

                tutorial != null -> TutorialStrip(state.learning, onEvent)
            }
            if (tutorial != null) HorizontalDivider(color = line)
            WorldAndProgram(state, onEvent, whole, first, Modifier.weight(1f))
            HorizontalDivider(color = line)
            runBar()
            RunAnnouncements(state)
        }
    }
}

/**
 * @param screen the height of the screen, of which the program has a share.
 * @param first the share that it has until another is chosen.
 */
@Composable
private fun WorldAndProgram(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    screen: Dp,
    first: Float,
    modifier: Modifier,
) {
    val chosen = rememberChosenShare(WindowForm.UPRIGHT, onEvent)
    BoxWithConstraints(modifier) {
        val whole = maxHeight
        val rest = (screen - whole) / screen
        val shares = sharesOf(
            screen,
            minOf(MIN_PROGRAM_HEIGHT, whole / 2),
            minOf(MIN_WORLD_HEIGHT, whole / 2) + screen * rest,
        )
        val share = (chosen.of(state.settings) ?: first).coerceIn(shares)
        val program = screen * share
        Column(Modifier.fillMaxSize()) {
            if (state.fullPane != Pane.PROGRAM) {
                WorldColumn(
                    state,
                    WindowForm.UPRIGHT,
                    onEvent,
                    (whole - if (state.fullPane == null) program else 0.dp) * MAX_DRAWER_SHARE,
                    Modifier.weight(1f),
                )
            }
            if (state.fullPane == null) HorizontalDivider()
            if (state.fullPane != Pane.WORLD) {
                ProgramPane(
                    state.programs,
                    state.part { shownProgramRun },
                    state.settings,
                    MAX_DIAGNOSTICS,
                    onEvent,
                    Modifier.fillMaxWidth().run { if (state.fullPane == null) height(program) else weight(1f) },
                    tutorialStep = state.learning.loadedStep,
                )
            }
        }
        if (state.fullPane == null) {
            PaneDivider(
                Orientation.Vertical,
                share,
                SharedRoom(with(LocalDensity.current) { screen.toPx() }, shares),
                chosen::put,
                Modifier.offset(y = whole - program - GRIP / 2),
                isProgramFirst = false,
            )
        }
    }
}

/** From this font scale on the tutorial needs more of the screen. */
private const val LARGE = 1.3f
private const val TUTORIAL_SHARE = 0.25f
private const val TUTORIAL_SHARE_LARGE = 0.3f
private const val PROGRAM_SHARE = 0.45f
private const val PROGRAM_SHARE_READING = 0.3f
private const val PROGRAM_SHARE_LARGE = 0.24f
private const val MAX_DRAWER_SHARE = 0.35f
private const val MAX_DIAGNOSTICS = 3

/** Tabs, tools and some lines of the program fit into this height. */
private val MIN_PROGRAM_HEIGHT = 240.dp

/** The row below the paper, and paper that can still be read. */
private val MIN_WORLD_HEIGHT = 264.dp
