package robotran.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.runcontrol.RunOutcome
import robotran.workshop.service.Notices
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction

/**
 * Holds the message at the bottom of the screen.
 *
 * @param isVisiting whether a hand-in is replayed.
 * @param canUndo whether an undo that a notice offers is still possible.
 * @param outcome of the present run.
 */
internal class NoticeStateHolder(
    private val isVisiting: () -> Boolean,
    private val canUndo: (NoticeAction) -> Boolean,
    private val outcome: () -> RunOutcome,
) : Notices {
    private var latest: Notice? by mutableStateOf(null)

    /** While a hand-in is replayed, there is always the way back; that it is solved is said elsewhere. */
    val shown: Notice?
        get() = latest.takeUnless { it is Notice.WorldSolved && isVisiting() }
            ?: Notice.HandInOpen.takeIf { isVisiting() }

    override fun show(notice: Notice) {
        latest = notice
    }

    override fun add(warnings: List<String>) {
        if (warnings.isNotEmpty()) latest = Notice.WithWarnings(latest, warnings)
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Leaving -> if (event.isAnother) projectOpened()

            is ProjectRoomEvent.Opened, is ProjectRoomEvent.WorldChanged -> {
                withdrawPraise(outcome())
                withdrawUndo()
            }

            is ProjectRoomEvent.WorldSaved, ProjectRoomEvent.Touched -> withdrawUndo()
            is RunRoomEvent.Changed -> withdrawPraise(event.outcome)

            is ProgramRoomEvent.Written -> {
                dismissIf { it == Notice.FirstProgramRuns }
                if (event.byUser) projectUsed()
            }

            RunRoomEvent.Pressed -> dismissIf { it is Notice.SensorsPluggedIn }
            is RunRoomEvent.Started, is ProgramRoomEvent.SnippetRequested, WorldRoomEvent.Edited -> projectUsed()
            is ProjectRoomEvent.RunSettingsChanged, ProjectRoomEvent.AssignmentChanged, ProgramRoomEvent.Chosen,
            ProgramRoomEvent.DebuggingChanged, ProgramRoomEvent.CompileBegun, is ProgramRoomEvent.Compiled,
            is RunRoomEvent.PointShown, is RunRoomEvent.Told,
            is WorldRoomEvent.EditorRequested, WorldRoomEvent.EditorOpening,
            is WorldRoomEvent.EditorClosed, is WorldRoomEvent.RobotOpened, is SchoolRoomEvent, is WindowRoomEvent,
            -> Unit
        }
    }

    fun dismiss() {
        latest = null
    }

    override fun dismissIf(isOver: (Notice) -> Boolean) {
        val notice = latest
        if (notice is Notice.WithWarnings) {
            if (notice.notice?.let(isOver) == true) latest = notice.copy(notice = null)
        } else if (notice?.let(isOver) == true) {
            latest = null
        }
    }

    /** The pupil has run or changed the open project, and so goes on with it: the way back to the last one is over. */
    private fun projectUsed() = dismissIf { it is Notice.EarlierProjectSaved }

    /** Another project is open: how the last one came to be open, and its files and robots, are no matter any more. */
    private fun projectOpened() {
        if (latest is Notice.WithWarnings || latest?.isOfProject == true) latest = null
    }

    /** That all goals are met is said only of the present run in the present world. */
    private fun withdrawPraise(outcome: RunOutcome) {
        if (!outcome.allMet) dismissIf { it is Notice.WorldSolved }
    }

    /** Dismisses the notice and returns the action that it offers; null if it offers none. */
    fun take(): NoticeAction? = shown?.action.also { latest = null }

    /** Removes an offer to undo what cannot be undone any more. */
    private fun withdrawUndo() = dismissIf { notice -> notice.action?.let { !canUndo(it) } ?: false }
}
