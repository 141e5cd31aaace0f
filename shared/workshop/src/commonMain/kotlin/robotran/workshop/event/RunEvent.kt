package robotran.workshop.event

import robotran.projects.ProjectSettings
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.log.RomLogFilter
import robotran.rcxrom.program.StepKind
import robotran.runcontrol.ChartLane
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.simulation.SessionInput
import robotran.workshop.state.DrawerTab

/** Something a person does with the run. */
sealed interface RunEvent : WorkshopEvent {
    /** Run in the run bar: the robot goes back to its start on a clean sheet and the program runs. */
    data object RunPressed : RunEvent

    /** Stop in the run bar: the program ends where it is. */
    data object StopPressed : RunEvent

    /** Time is to stand still, or to go on. */
    data object PausePressed : RunEvent

    /** The program is to make one step; where none runs, it begins and stops before its first line. */
    data class StepPressed(val kind: StepKind) : RunEvent

    /** The program is to run until it stands before [line]; where none runs, it begins. */
    data class RunToLine(val line: Breakpoint) : RunEvent

    /** The robot goes back to its start on a clean sheet and waits. */
    data object StartedOver : RunEvent

    data class SpeedChosen(val speed: RunSpeed) : RunEvent

    /** The run is to be looked at as it was, or will be, at [milliseconds]. */
    data class Scrubbed(val milliseconds: Long) : RunEvent

    /** The robot with this number is to be looked into. */
    data class RobotWatched(val robot: Int) : RunEvent

    /** What was done to the run that came with the project is to be done again. */
    data object RecordingPlayed : RunEvent

    /** How the programs run is to be changed. */
    data class RunSettingsChanged(val settings: ProjectSettings) : RunEvent

    /** A finger, a mouse or a key goes down on a button of the brick. */
    data class ButtonPressed(val button: BrickButton) : RunEvent

    /** It comes up again. */
    data class ButtonReleased(val button: BrickButton) : RunEvent

    /** Something is done to the session by hand, such as dragging the robot; it is recorded with its time. */
    data class SessionTouched(val input: SessionInput) : RunEvent

    /** The drawer is to show [tab]; null to close it. */
    data class DrawerChosen(val tab: DrawerTab?) : RunEvent

    /** The drawer is to show [tab] next to what it shows already; null to show that alone. */
    data class DrawerBesideChosen(val tab: DrawerTab?) : RunEvent

    /** The thread with this number, and the place in its call stack, are to be looked into. */
    data class FrameChosen(val thread: Int, val frame: Int) : RunEvent

    /** Only what [filter] lets through is to be seen of the ROM calls. */
    data class LogFiltered(val filter: RomLogFilter) : RunEvent

    /** The ROM calls that are shown are to be copied. */
    data object LogCopied : RunEvent

    /** The ROM calls that are shown are to be saved as a file. */
    data object LogSaved : RunEvent

    /** [lane] of the chart is to be seen or not. */
    data class LaneSwitched(val lane: ChartLane) : RunEvent
}
