package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.rom.BrickButton
import robotran.rom.RunState
import robotran.world.SessionState
import robotran.world.World

/**
 * The run as it is shown.
 *
 * @property world what it takes place in.
 * @property changed whether the programs differ from those in the brick.
 * @property down the buttons of the brick that somebody holds; the brick itself may not have noticed them.
 * @property untouched true until a program is run for the first time.
 * @property awake whether time has to go on, because something moves, sounds or waits.
 */
@Immutable
data class RunPaneState(
    val world: World,
    val session: SessionState,
    val changed: Boolean = false,
    val down: Set<BrickButton> = emptySet(),
    val untouched: Boolean = true,
    val awake: Boolean = true,
) {
    val running: Boolean get() = session.brick.run is RunState.Running

    /** Whether there is anything to stop: a program that runs, or that shows why it cannot go on. */
    val stoppable: Boolean get() = running || (session.brick.run is RunState.Failed && session.brick.explanation != null)
}
