package robotran.ui.screen

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.ui.drawer.RunAnnouncer
import robotran.ui.drawer.RunDrawer
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.parts.LocalKeyboardHeight
import robotran.ui.program.ProgramPane
import robotran.ui.runbar.RunBar
import robotran.ui.runbar.SoundSwitch
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorkshopState

/**
 * A tablet in portrait: the tutorial, if open, in a wide strip; below it paper and brick, the run bar, and the program.
 */
@Composable
internal fun UprightScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val tutorial = state.learning.tutorial
    val keyboard = LocalKeyboardHeight.current
    val line = LocalRobotranColours.current.line
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val whole = maxHeight + keyboard
        // Above an on-screen keyboard there is room only for the program and part of the paper.
        val isTutorialOpen = tutorial != null && !tutorial.isFolded && keyboard == 0.dp
        val isLarge = LocalDensity.current.fontScale > LARGE
        val tutorialShare = if (isLarge) TUTORIAL_SHARE_LARGE else TUTORIAL_SHARE
        val program = whole * when {
            !isTutorialOpen -> PROGRAM_SHARE
            isLarge -> PROGRAM_SHARE_LARGE
            else -> PROGRAM_SHARE_READING
        }
        Column(Modifier.fillMaxSize()) {
            TopStrip(state.document, state.soundOn, state.worldEdit != null, onEvent)
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
            BoxWithConstraints(Modifier.weight(1f)) {
                val max = maxHeight * if (isTutorialOpen) MAX_DRAWER_SHARE_READING else MAX_DRAWER_SHARE
                Column(Modifier.fillMaxSize()) {
                    Desk(state, onEvent, Modifier.weight(1f))
                    RunDrawer(state.run, onEvent, max = max)
                    RunBar(state.run, state.status, state.caretLine, onEvent) {
                        SoundSwitch(state.soundOn, { onEvent(SettingsEvent.SoundSwitched(it)) })
                    }
                }
            }
            HorizontalDivider(color = line)
            ProgramPane(
                state.programs,
                state.shownProgramRun,
                state.settings,
                MAX_DIAGNOSTICS,
                onEvent,
                Modifier.fillMaxWidth().height(program),
                tutorialStep = state.learning.loadedStep,
            )
            RunAnnouncer(state.run)
        }
    }
}

/** From this font scale on the tutorial needs more of the screen. */
private const val LARGE = 1.3f
private const val TUTORIAL_SHARE = 0.25f
private const val TUTORIAL_SHARE_LARGE = 0.3f
private const val PROGRAM_SHARE = 0.37f
private const val PROGRAM_SHARE_READING = 0.3f
private const val PROGRAM_SHARE_LARGE = 0.24f
private const val MAX_DRAWER_SHARE = 0.5f
private const val MAX_DRAWER_SHARE_READING = 0.28f
private const val MAX_DIAGNOSTICS = 3
