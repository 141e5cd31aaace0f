package robotran.workshop.screen

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.workshop.event.ScreenEvent
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RoomEvents
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.Pane

/**
 * Holds which pane is shown, and whether the task of the world is.
 *
 * @param hasTask whether the world has a task to show.
 * @param openSite opens the settings page at the base URL of links.
 */
internal class ScreenStateHolder(
    private val events: RoomEvents,
    private val hasTask: () -> Boolean,
    private val openSite: () -> Unit,
) : ScreenNavigator {
    /** The pane shown on screens with room for only one. */
    var pane by mutableStateOf(Pane.WORLD)
        private set

    /** The pane that has the room of all others, on screens with room for several; null for none. */
    var fullPane: Pane? by mutableStateOf(null)
        private set

    /** Whether the world's task is shown above the sheet. */
    var taskShown by mutableStateOf(false)
        private set

    /** Whether only one line of it is shown. */
    var taskFolded by mutableStateOf(false)
        private set

    fun handle(event: ScreenEvent) {
        when (event) {
            is ScreenEvent.PaneChosen -> pane = event.pane
            is ScreenEvent.PaneFilled -> fullPane = event.pane
            is ScreenEvent.TaskShown -> showTask(event.shown)
            is ScreenEvent.TaskFolded -> taskFolded = event.folded
        }
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened -> worldChanged(hasNewTask = true)
            is ProjectRoomEvent.WorldChanged -> worldChanged(event.isAnother || event.hasNewTask)
            // Only its line stays, so that there is room for what comes of the run.
            is ProgramRoomEvent.SnippetRequested -> taskFolded = true
            is RunRoomEvent.Started -> if (event.byUser) taskFolded = true
            is ProjectRoomEvent.Leaving, is ProjectRoomEvent.WorldSaved, is ProjectRoomEvent.RunSettingsChanged,
            ProjectRoomEvent.AssignmentChanged, ProjectRoomEvent.Touched, is ProgramRoomEvent.Written,
            ProgramRoomEvent.Chosen, ProgramRoomEvent.DebuggingChanged, ProgramRoomEvent.CompileBegun,
            is ProgramRoomEvent.Compiled, RunRoomEvent.Pressed, is RunRoomEvent.Changed, is RunRoomEvent.PointShown,
            is RunRoomEvent.Told,
            is WorldRoomEvent, is SchoolRoomEvent, is WindowRoomEvent,
            -> Unit
        }
    }

    override fun show(pane: Pane) {
        this.pane = pane
        if (fullPane != pane) fullPane = null
    }

    override fun hideTask() = showTask(false)

    override fun leavePages() = events.publish(WindowRoomEvent.PagesLeft)

    override fun openSiteSetting() = openSite()

    private fun worldChanged(hasNewTask: Boolean) {
        if (hasNewTask) showTask(hasTask())
        if (taskShown) show(Pane.WORLD)
    }

    /** The whole task; who asks for it wants to read it. */
    private fun showTask(shown: Boolean) {
        taskShown = shown
        taskFolded = false
    }
}
