package robotran.ui.screen

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.width
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.ui.drawer.RunAnnouncer
import robotran.ui.drawer.RunDrawer
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.parts.ScreenLayout
import robotran.ui.program.ProgramPane
import robotran.ui.runbar.RunBar
import robotran.ui.runbar.SoundSwitch
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorkshopState

/** Tablet and laptop: the tutorial if open, the program, next to it paper and brick above the run bar. */
@Composable
internal fun WideScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val tutorial = state.learning.tutorial
    val isTutorialOpen = tutorial != null && !tutorial.isFolded
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val isRoomy = maxWidth >= TUTORIAL_BESIDE_WIDTH * ScreenLayout.widthScale(LocalDensity.current.fontScale)
        val tutorialWidth = (maxWidth * TUTORIAL_SHARE).coerceAtMost(MAX_TUTORIAL_WIDTH)
        Column(Modifier.fillMaxSize()) {
            TopStrip(state.document, state.soundOn, state.worldEdit != null, onEvent)
            HorizontalDivider(color = LocalRobotranColours.current.line)
            if (tutorial != null && !isTutorialOpen) TutorialStrip(state.learning, onEvent)
            Row(Modifier.weight(1f)) {
                if (isTutorialOpen && isRoomy) {
                    TutorialPane(state.learning, onEvent, Modifier.width(tutorialWidth).fillMaxHeight())
                    VerticalDivider(color = LocalRobotranColours.current.line)
                }
                ProgramAndDesk(state, onEvent, isTutorialOpen && !isRoomy, Modifier.weight(1f))
            }
        }
    }
}

/** With the tutorial above the program if [isTutorialOpen]. */
@Composable
private fun ProgramAndDesk(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    isTutorialOpen: Boolean,
    modifier: Modifier,
) {
    // 0 until the divider is moved.
    var dragged by rememberSaveable { mutableFloatStateOf(0f) }
    BoxWithConstraints(modifier.fillMaxHeight()) {
        val whole = maxWidth
        val tall = maxHeight
        val view = state.programs.view
        val share = if (dragged > 0) dragged else shareFor(view)
        val wanted = if (dragged == 0f && view.hasBlocks) MIN_BLOCKS_WIDTH else MIN_PROGRAM_WIDTH
        val least = wanted * ScreenLayout.widthScale(LocalDensity.current.fontScale)
        val left = maxOf(whole * share, minOf(least, whole / 2))
        Row(Modifier.fillMaxSize()) {
            Column(Modifier.width(left).fillMaxHeight()) {
                if (isTutorialOpen) {
                    TutorialPane(state.learning, onEvent, Modifier.weight(1f))
                    HorizontalDivider(color = LocalRobotranColours.current.line)
                }
                ProgramPane(
                    state.programs,
                    state.shownProgramRun,
                    state.settings,
                    MAX_DIAGNOSTICS,
                    onEvent,
                    Modifier.weight(1f),
                    tutorialStep = state.learning.loadedStep,
                )
            }
            Column(Modifier.weight(1f).fillMaxHeight()) {
                Desk(state, onEvent, Modifier.weight(1f))
                RunDrawer(state.run, onEvent, max = tall * MAX_DRAWER_SHARE)
                RunBar(state.run, state.status, state.caretLine, onEvent) {
                    SoundSwitch(state.soundOn, { onEvent(SettingsEvent.SoundSwitched(it)) })
                }
            }
        }
        val pixels = with(LocalDensity.current) { whole.toPx() }
        RunAnnouncer(state.run)
        PaneDivider(left / whole, pixels, { dragged = it }, Modifier.offset(x = left - 12.dp))
    }
}

/** The part of the width that the program has until the divider is moved. */
private fun shareFor(view: ProgramView): Float = when (view) {
    ProgramView.TEXT -> PROGRAM_SHARE
    ProgramView.BLOCKS -> BLOCKS_SHARE
    ProgramView.BOTH -> BOTH_SHARE
}

/** From this width on, at default font size, the tutorial has its own column. */
private val TUTORIAL_BESIDE_WIDTH = 1100.dp
private val MAX_TUTORIAL_WIDTH = 328.dp
private const val TUTORIAL_SHARE = 0.26f
private const val PROGRAM_SHARE = 0.32f
private const val BLOCKS_SHARE = 0.35f
private const val BOTH_SHARE = 0.58f
private const val MAX_DIAGNOSTICS = 3
private const val MAX_DRAWER_SHARE = 0.6f

/** The row of tools above the program fits into this width. */
private val MIN_PROGRAM_WIDTH = 320.dp

/** Blocks with their groups beside them fit into this width. */
private val MIN_BLOCKS_WIDTH = 456.dp
