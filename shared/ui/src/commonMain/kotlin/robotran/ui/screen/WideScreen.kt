package robotran.ui.screen

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.parts.ScreenLayout
import robotran.ui.program.ProgramPane
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.Pane
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WorkshopState

/**
 * Tablet and laptop: the tutorial if open, the program, next to it the world; below all of them the run bar.
 *
 * @param runBar the run bar.
 */
@Composable
internal fun WideScreen(
    state: WorkshopState,
    form: WindowForm,
    onEvent: (WorkshopEvent) -> Unit,
    runBar: @Composable () -> Unit,
) {
    val tutorial = state.learning.tutorial
    val isTutorialOpen = tutorial != null && !tutorial.isFolded
    BoxWithConstraints(Modifier.fillMaxSize()) {
        // With one pane alone there is room beside it.
        val isRoomy = maxWidth >= TUTORIAL_BESIDE_WIDTH * ScreenLayout.widthScale(LocalDensity.current.fontScale) ||
            state.fullPane == Pane.WORLD
        val tutorialWidth = (maxWidth * TUTORIAL_SHARE).coerceIn(MIN_TUTORIAL_WIDTH, MAX_TUTORIAL_WIDTH)
        Column(Modifier.fillMaxSize()) {
            TopStrip(state.document, state.worldEdit != null, state.fullPane, onEvent)
            HorizontalDivider()
            if (tutorial != null && !isTutorialOpen) TutorialStrip(state.learning, onEvent)
            Row(Modifier.weight(1f)) {
                if (isTutorialOpen && isRoomy) {
                    TutorialPane(state.learning, onEvent, Modifier.width(tutorialWidth).fillMaxHeight())
                    VerticalDivider()
                }
                ProgramAndWorld(state, form, onEvent, isTutorialOpen && !isRoomy, Modifier.weight(1f))
            }
            HorizontalDivider()
            runBar()
            RunAnnouncements(state)
        }
    }
}

/** With the tutorial above the program if [isTutorialOpen]. */
@Composable
private fun ProgramAndWorld(
    state: WorkshopState,
    form: WindowForm,
    onEvent: (WorkshopEvent) -> Unit,
    isTutorialOpen: Boolean,
    modifier: Modifier,
) {
    val chosen = rememberChosenShare(form, onEvent)
    BoxWithConstraints(modifier.fillMaxHeight()) {
        val whole = maxWidth
        val view = state.programs.view
        val scale = ScreenLayout.widthScale(LocalDensity.current.fontScale)
        val wanted = chosen.of(state.settings)
        val least = if (wanted == null && view.hasBlocks) MIN_BLOCKS_WIDTH else MIN_PROGRAM_WIDTH
        val shares = sharesOf(whole, minOf(least * scale, whole / 2), MIN_WORLD_WIDTH)
        val share = (wanted ?: shareFor(view)).coerceIn(shares)
        val left = whole * share
        Row(Modifier.fillMaxSize()) {
            if (state.fullPane != Pane.WORLD) {
                val width = if (state.fullPane == null) Modifier.width(left) else Modifier.weight(1f)
                Column(width.fillMaxHeight()) {
                    if (isTutorialOpen) {
                        if (state.part { programs.blocks?.sheet != null && programs.view.hasBlocks }) {
                            YieldingTutorial(state.learning, onEvent)
                        } else {
                            TutorialPane(state.learning, onEvent, Modifier.weight(TUTORIAL_WEIGHT * scale))
                        }
                        HorizontalDivider()
                    }
                    ProgramPane(
                        state.programs,
                        state.part { shownProgramRun },
                        state.settings,
                        MAX_DIAGNOSTICS,
                        onEvent,
                        Modifier.weight(1f),
                        tutorialStep = state.learning.loadedStep,
                    )
                }
            }
            if (state.fullPane != Pane.PROGRAM) {
                WorldColumn(
                    state,
                    form,
                    onEvent,
                    this@BoxWithConstraints.maxHeight * MAX_DRAWER_SHARE,
                    Modifier.weight(1f).fillMaxHeight(),
                )
            }
        }
        if (state.fullPane == null) {
            val room = SharedRoom(with(LocalDensity.current) { whole.toPx() }, shares)
            PaneDivider(
                Orientation.Horizontal,
                share,
                room,
                chosen::put,
                Modifier.offset(x = left - GRIP / 2),
            )
        }
    }
}

/** One line of the tutorial, so that a sheet of the blocks and what it is about have room. Opening it closes that sheet. */
@Composable
private fun YieldingTutorial(learning: LearningState, onEvent: (WorkshopEvent) -> Unit) {
    val folded = learning.copy(tutorial = learning.tutorial?.copy(isFolded = true))
    TutorialStrip(folded, {
        onEvent(if (it == LearningEvent.TutorialFolded(false)) BlockEvent.DialogShown(null) else it)
    })
}

/** The part of the width that the program has until the divider is moved. */
private fun shareFor(view: ProgramView): Float = when (view) {
    ProgramView.TEXT -> PROGRAM_SHARE
    ProgramView.BLOCKS -> BLOCKS_SHARE
    ProgramView.BOTH -> BOTH_SHARE
}

/** From this width on, at default font size, the tutorial has its own column and the sheet still has most room. */
private val TUTORIAL_BESIDE_WIDTH = 1600.dp
private val MAX_TUTORIAL_WIDTH = 328.dp
private val MIN_TUTORIAL_WIDTH = 280.dp
private const val TUTORIAL_SHARE = 0.26f

/** The height of the tutorial above a program that is 1 high: a task with its latest hint fits. Larger text needs more. */
private const val TUTORIAL_WEIGHT = 1.2f
private const val PROGRAM_SHARE = 0.32f
private const val BLOCKS_SHARE = 0.35f
private const val BOTH_SHARE = 0.58f
private const val MAX_DIAGNOSTICS = 3
private const val MAX_DRAWER_SHARE = 0.6f

/** The row of tools above the program fits into this width. */
private val MIN_PROGRAM_WIDTH = 320.dp

/** Blocks with their groups beside them fit into this width. */
private val MIN_BLOCKS_WIDTH = 456.dp

/** Paper with its buttons, and the row below them, fit into this width. */
private val MIN_WORLD_WIDTH = 360.dp
