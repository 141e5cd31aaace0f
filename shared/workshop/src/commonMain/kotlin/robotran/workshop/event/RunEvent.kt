package robotran.workshop.event

import robotran.brick.controls.BrickButton
import robotran.brick.log.CallLogFilter
import robotran.brick.program.StepKind
import robotran.projects.ProjectSettings
import robotran.runcontrol.ChartLane
import robotran.runcontrol.RunSpeed
import robotran.runsound.SoundSample
import robotran.simulation.Breakpoint
import robotran.simulation.SessionInput
import robotran.simulation.state.GoalShortfall
import robotran.workshop.state.DrawerTab

/** A user action on the run. */
sealed interface RunEvent : WorkshopEvent {
    /** Run in the run bar: the robot returns to its start on an empty sheet and the program runs. */
    data object RunPressed : RunEvent

    /** Stop in the run bar: the program ends at once. */
    data object StopPressed : RunEvent

    /** Pauses or resumes time. */
    data object PausePressed : RunEvent

    /** Executes one step; if no program runs, starts it and stops before its first line. */
    data class StepPressed(val kind: StepKind) : RunEvent

    /** Runs the program until it reaches [line]; starts it if it is not running. */
    data class RunToLine(val line: Breakpoint) : RunEvent

    /** Returns the robot to its start on an empty sheet without running the program. */
    data object StartedOver : RunEvent

    data class SpeedChosen(val speed: RunSpeed) : RunEvent

    /** Shows the run at [milliseconds], in the past or future. */
    data class Scrubbed(val milliseconds: Long) : RunEvent

    /** Makes what robots do heard, or no longer, and says so. */
    data object HearingSwitched : RunEvent

    /** Plays a sound of runs, to be learned. */
    data class SampleRequested(val sample: SoundSample) : RunEvent

    /** Shows the moment and the place of what was missing for a goal. */
    data class ShortfallShown(val shortfall: GoalShortfall) : RunEvent

    /** Tells what happened in the run so far, and from now on in each run of this project when it ends. */
    data object StoryRequested : RunEvent

    /** Shows the internals of the robot with this index. */
    data class DebuggedRobotChosen(val robot: Int) : RunEvent

    /** Replays the recorded run of the project. */
    data object RecordingPlayed : RunEvent

    /** Changes the settings of runs. */
    data class RunSettingsChanged(val settings: ProjectSettings) : RunEvent

    /** Presses a button of the brick by touch, mouse or key. */
    data class ButtonPressed(val button: BrickButton) : RunEvent

    /** Releases the button. */
    data class ButtonReleased(val button: BrickButton) : RunEvent

    /** Applies a manual input to the session, such as dragging the robot; it is recorded with its time. */
    data class SessionTouched(val input: SessionInput) : RunEvent

    /** An action on the drawer below the world. */
    sealed interface OfDrawer : RunEvent

    /** Shows [tab] in the drawer; null closes it. */
    data class DrawerChosen(val tab: DrawerTab?) : OfDrawer

    /** Shows [tab] next to the current tab of the drawer; null shows the current tab alone. */
    data class DrawerBesideChosen(val tab: DrawerTab?) : OfDrawer

    /** Shows a thread and a frame in its call stack, by their indices. */
    data class FrameChosen(val thread: Int, val frame: Int) : OfDrawer

    /** Shows only the ROM calls that match [filter]. */
    data class LogFiltered(val filter: CallLogFilter) : OfDrawer

    /** Copies the visible ROM calls. */
    data object LogCopied : OfDrawer

    /** Saves the visible ROM calls to a file. */
    data object LogSaved : OfDrawer

    /** Saves the datalog of LEGO's firmware to a file. */
    data object DatalogSaved : OfDrawer

    /** Shows or hides [lane] in the chart. */
    data class LaneSwitched(val lane: ChartLane) : OfDrawer
}
