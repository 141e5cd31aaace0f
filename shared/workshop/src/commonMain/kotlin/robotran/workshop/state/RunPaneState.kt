package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.controls.BrickButton
import robotran.brick.program.CallFrame
import robotran.brick.state.BrickState
import robotran.brick.state.RunState
import robotran.projects.ProjectSettings
import robotran.runcontrol.CallCountLine
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunOutcome
import robotran.runcontrol.RunSpeed
import robotran.runcontrol.TimelineMark
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * The state of the run.
 *
 * @property world the world of the run.
 * @property session the session at the current time.
 * @property drawn the state to draw; in slow motion, positions are interpolated between physics steps.
 * @property changed whether the programs differ from those on the brick.
 * @property down the buttons of the brick that the user holds; the brick may not have read them yet.
 * @property untouched true until a program is run for the first time.
 * @property awake whether time must advance, because something moves, sounds or waits.
 * @property playback the playback state.
 * @property time the current time in the run, in milliseconds.
 * @property length the known length of the run, in milliseconds.
 * @property marks the events of the run, including those after [time].
 * @property calls the times of the ROM calls of the [watched] robot, including those after [time].
 * @property watched the index of the chosen robot: its program, brick, status and variables are shown.
 * @property hasRecording whether the project has recorded inputs.
 * @property settings how programs run.
 * @property frame the selected frame of the [watched] robot's program, whose line is shown; null for the current line.
 * @property outcome the goals at the end of the known run, also while an earlier time is shown.
 * @property snippetOf for each robot, the program that it got to run at once, if it runs or was the last one to run.
 */
@Immutable
data class RunPaneState(
    val world: World,
    val session: SessionState,
    val drawer: DrawerState,
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
    val calls: CallCountLine? = null,
    val watched: Int = 0,
    val hasRecording: Boolean = false,
    val settings: ProjectSettings = ProjectSettings(),
    val frame: CallFrame? = null,
    val snippetOf: List<Snippet?> = emptyList(),
    val outcome: RunOutcome = RunOutcome(),
) {
    /** What was missing for the goals, as far as the run is known. */
    val shortfalls: List<ShortfallMark> get() = shortfallMarks(outcome.goals)

    /** The robots that have left the paper. */
    val strayed: List<StrayedRobot> get() = strayedRobots(world, session)

    /** Whether this is the end of a run that has met all goals. */
    val isSolved: Boolean get() = outcome.isSolved && time >= (outcome.finished ?: 0)

    /** Whether the run ended at the world's time limit without having met all goals. */
    val isTimeUp: Boolean
        get() = !outcome.isSolved && (outcome.finished ?: 0) >= world.timeLimit * 1_000L

    /** The brick of the [watched] robot. */
    val brick: BrickState get() = session.robots[watched].brick

    /** Whether any robot runs a program. */
    val running: Boolean get() = session.robots.any { it.brick.run is RunState.Running }

    /** Whether there is anything to stop: a running program, or one that shows an error. */
    val stoppable: Boolean
        get() = running || session.robots.any { it.brick.run is RunState.Failed && it.brick.explanation != null }

    val isPaused: Boolean get() = playback == PlaybackState.Paused

    val isPlaying: Boolean get() = playback is PlaybackState.Playing

    /** Whether playback is seeking to another time. */
    val isSeeking: Boolean get() = playback is PlaybackState.Seeking

    /** Whether the known run continues after this time. */
    val inPast: Boolean get() = time < length

    /** Whether time can be paused or resumed. */
    val pausable: Boolean get() = !isPlaying || running || (awake && inPast)

    /** Whether playback is slow enough to highlight the running line. */
    val lineIsLit: Boolean get() = !isPlaying || !speed.isFast
}
