package robotran.workshop.service

import robotran.programs.Program
import robotran.projects.Project
import robotran.world.World

/** What has happened to the open project. */
sealed interface ProjectRoomEvent : RoomEvent {
    /** The open project is about to be replaced, or, unless [isAnother], its world to be edited. */
    data class Leaving(val isAnother: Boolean) : ProjectRoomEvent

    /** [project] is the open one now. */
    data class Opened(val project: Project) : ProjectRoomEvent

    /**
     * The robots drive in the world of [project] from now on.
     *
     * @property isAnother whether it is a different world, not an edited one.
     * @property hasNewTask whether its title or task is another one.
     * @property isLeftBehind which programs belong to the previous world and do not come along.
     * @property beginning the program to begin with there, for a pupil who has none of their own; null for none.
     */
    data class WorldChanged(
        val project: Project,
        val isAnother: Boolean,
        val hasNewTask: Boolean,
        val isLeftBehind: (Program) -> Boolean,
        val beginning: Program? = null,
    ) : ProjectRoomEvent

    /** [world] is saved, while robots still drive in the previous one. In it a robot [isRenamed]. */
    data class WorldSaved(val world: World, val isRenamed: Boolean) : ProjectRoomEvent

    /** The programs of [project] run with other settings. */
    data class RunSettingsChanged(val project: Project) : ProjectRoomEvent

    /** The assignment of the open project, or the tries at it, are others. */
    data object AssignmentChanged : ProjectRoomEvent

    /** The open project may have changed in any other way, such as by files that a robot has written. */
    data object Touched : ProjectRoomEvent
}
