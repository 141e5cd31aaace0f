package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.projects.ProjectSettings
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.state.BrickState
import robotran.rcxrom.state.RunState
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RomCallLine
import robotran.runcontrol.RunSpeed
import robotran.runcontrol.TimelineMark
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * The run as it is shown.
 *
 * @property world what it takes place in.
 * @property session the run at the time that is looked at.
 * @property drawn the same as it is best drawn: in slow motion with what moves between two steps of the physics.
 * @property changed whether the programs differ from those in the brick.
 * @property down the buttons of the brick that somebody holds; the brick itself may not have noticed them.
 * @property untouched true until a program is run for the first time.
 * @property awake whether time has to go on, because something moves, sounds or waits.
 * @property playback what the run is doing.
 * @property time where in the run it is, in milliseconds.
 * @property length how much of the run is known, in milliseconds.
 * @property marks what has happened in the run, also after [time].
 * @property calls when the robot that is [watched] makes its ROM calls, also after [time].
 * @property watched the number of the robot that is looked into.
 * @property hasRecording whether the project came with what was done to a run.
 * @property settings how the programs run.
 */
@Immutable
data class RunPaneState(
    val world: World,
    val session: SessionState,
    val drawn: SessionState = session,
    val changed: Boolean = false,
    val down: Set<BrickButton> = emptySet(),
    val untouched: Boolean = true,
    val awake: Boolean = true,
    val playback: PlaybackState = PlaybackState.Playing(),
    val speed: RunSpeed = RunSpeed.REAL_TIME,
    val time: Long = 0,
    val length: Long = 0,
    val marks: List<TimelineMark> = emptyList(),
    val calls: RomCallLine? = null,
    val watched: Int = 0,
    val hasRecording: Boolean = false,
    val settings: ProjectSettings = ProjectSettings(),
    val drawer: DrawerState = DrawerState(),
) {
    /** The brick of the robot that is [watched]. */
    val brick: BrickState get() = session.robots[watched].brick

    /** Whether a program runs, of whichever robot. */
    val running: Boolean get() = session.robots.any { it.brick.run is RunState.Running }

    /** Whether there is anything to stop: a program that runs, or that shows why it cannot go on. */
    val stoppable: Boolean
        get() = running || session.robots.any { it.brick.run is RunState.Failed && it.brick.explanation != null }

    val isPaused: Boolean get() = playback == PlaybackState.Paused

    val isPlaying: Boolean get() = playback is PlaybackState.Playing

    /** Whether it is on the way to another time. */
    val isSeeking: Boolean get() = playback is PlaybackState.Seeking

    /** Whether the run had gone on from here before. */
    val inPast: Boolean get() = time < length

    /** Whether time can be made to stand still, or to go on. */
    val pausable: Boolean get() = !isPlaying || running || (awake && inPast)

    /** Whether the line that runs can be followed with the eyes. */
    val lineIsLit: Boolean get() = !isPlaying || !speed.isFast
}
