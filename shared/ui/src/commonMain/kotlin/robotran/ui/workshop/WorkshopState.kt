package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.robolang.Diagnostic
import robotran.rom.BrickButton
import robotran.rom.RunState
import robotran.world.SessionState
import robotran.world.World

/**
 * Everything the screen shows.
 *
 * @property programName what the program is called, usually the name of its file.
 * @property mistakes what is wrong with [programText], in its order.
 * @property changed whether [programText] differs from the program in the brick.
 * @property mistakePointedOut whether somebody wanted to run a program with mistakes since it was last edited.
 * @property down the buttons of the brick that somebody holds; the brick itself may not have noticed them.
 * @property pane what a screen with room for one pane shows.
 * @property untouched true until the program is run for the first time.
 * @property awake whether time has to go on, because something moves, sounds or waits.
 * @property soundOn whether the brick's tones are to be heard.
 */
@Immutable
data class WorkshopState(
    val programName: String,
    val programText: String,
    val mistakes: List<Diagnostic>,
    val changed: Boolean,
    val mistakePointedOut: Boolean,
    val world: World,
    val session: SessionState,
    val down: Set<BrickButton>,
    val pane: Pane,
    val untouched: Boolean,
    val awake: Boolean,
    val soundOn: Boolean,
) {
    val running: Boolean get() = session.brick.run is RunState.Running

    val status: WorkshopStatus
        get() = runStatus(session.brick.run).takeIf { running }
            ?: mistakes.firstOrNull()?.let { WorkshopStatus.Mistaken(it.range.line) }
            ?: WorkshopStatus.Empty.takeIf { programText.isBlank() }
            ?: WorkshopStatus.Off.takeIf { !session.brick.poweredOn }
            ?: WorkshopStatus.Changed.takeIf { changed }
            ?: runStatus(session.brick.run)

    private fun runStatus(run: RunState): WorkshopStatus = when (run) {
        RunState.Idle -> WorkshopStatus.Ready
        is RunState.Running -> WorkshopStatus.Running(run.sourceLine)
        is RunState.Ended -> WorkshopStatus.Ended(run.stopped)
        is RunState.Failed -> WorkshopStatus.Failed(run.failure.sourceLine, run.failure.message)
    }
}
