package robotran.workshop.service

import robotran.language.Language
import robotran.programs.Program
import robotran.projects.Course
import robotran.projects.Project
import robotran.runcontrol.RunOutcome
import robotran.simulation.state.SessionState
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.Settings
import robotran.workshop.state.Snippet
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.geometry.Point

/** What has happened in one room that others may follow. A room knows no other room; it publishes and subscribes. */
sealed interface RoomEvent {
    /** The open project is about to be replaced, or, unless [isAnother], its world to be edited. */
    data class ProjectLeaving(val isAnother: Boolean) : RoomEvent

    /** [project] is the open one now. */
    data class ProjectOpened(val project: Project) : RoomEvent

    /**
     * The robots drive in the world of [project] from now on.
     *
     * @property isAnother whether it is a different world, not an edited one.
     * @property hasNewTask whether its title or task is another one.
     * @property isLeftBehind which programs belong to the previous world and do not come along.
     */
    data class WorldChanged(
        val project: Project,
        val isAnother: Boolean,
        val hasNewTask: Boolean,
        val isLeftBehind: (Program) -> Boolean,
    ) : RoomEvent

    /** [world] is saved, while robots still drive in the previous one. In it a robot [isRenamed]. */
    data class WorldSaved(val world: World, val isRenamed: Boolean) : RoomEvent

    /** The user has changed the world in an editor. */
    data object WorldEdited : RoomEvent

    /** The programs of [project] run with other settings. */
    data class RunSettingsChanged(val project: Project) : RoomEvent

    /** The assignment of the open project, or the tries at it, are others. */
    data object AssignmentChanged : RoomEvent

    /** The open project may have changed in any other way, such as by files that a robot has written. */
    data object ProjectTouched : RoomEvent

    /** Programs have changed, or can run now. [byUser] is false for those that the app has put there. */
    data class ProgramsWritten(val byUser: Boolean) : RoomEvent

    /** Another program is shown. */
    data object ProgramChosen : RoomEvent

    /** A breakpoint was set or removed, or the programs of another robot are shown. */
    data object DebuggingChanged : RoomEvent

    /** Programs are going to be compiled, which may stop the app. */
    data object CompileBegun : RoomEvent

    /** The programs were compiled, or could not be. */
    data class ProgramsCompiled(val status: CompileStatus) : RoomEvent

    /** [snippet] is to run at once. */
    data class SnippetRequested(val snippet: Snippet) : RoomEvent

    /** Run was pressed in the run bar; nothing has started yet. */
    data object RunPressed : RoomEvent

    /** Programs were started. [byUser] is false for a program that started by itself, such as by a message. */
    data class RunStarted(val byUser: Boolean) : RoomEvent

    /**
     * The run goes on, or another one is shown.
     *
     * @property ended the try that is over, the same object until that changes.
     */
    class RunChanged(val session: SessionState, val outcome: RunOutcome, val ended: EndedAttempt?) : RoomEvent

    /** The user looks at [point] of the sheet, where a goal was missed. */
    data class PointShown(val point: Point) : RoomEvent

    /** The task has just been solved. */
    data object TaskSolved : RoomEvent

    /** The settings of this machine are [settings] now. */
    data class SettingsChanged(val settings: Settings) : RoomEvent

    data class LanguageChanged(val language: Language) : RoomEvent

    /** The world editor opens, for the world of the open project or for a [variation] of it. */
    data class WorldEditorRequested(val variation: Int?) : RoomEvent

    data object WorldEditorOpening : RoomEvent

    /** The world editor was closed; [leadsBack] is false if its world is tried out now. */
    data class WorldEditorClosed(val leadsBack: Boolean) : RoomEvent

    /** [robot] was opened from a file and takes the place of another one. */
    data class RobotOpened(val robot: RobotDescription) : RoomEvent

    /** A teacher looks at the hand-ins of [course]. */
    data class HandInsRequested(val course: Course) : RoomEvent

    /** The pages that cover the workshop are to close, for what a menu of the window has opened over them. */
    data object PagesLeft : RoomEvent
}

/** Delivers each [RoomEvent] to all rooms, in the order in which they subscribed. */
class RoomEvents {
    private val subscribers = mutableListOf<(RoomEvent) -> Unit>()

    fun subscribe(subscriber: (RoomEvent) -> Unit) {
        subscribers += subscriber
    }

    fun publish(event: RoomEvent) = subscribers.forEach { it(event) }
}
