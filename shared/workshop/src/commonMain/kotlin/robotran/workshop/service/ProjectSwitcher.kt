package robotran.workshop.service

import robotran.projects.Project
import robotran.world.World

/**
 * Opens another project in place of the one that is open, which stays among the saved ones. Asks before anything is
 * lost.
 */
interface ProjectSwitcher {
    /**
     * Opens [project].
     *
     * @param into the id of the saved project whose place it takes; if there is none, a new one called [name] begins.
     */
    suspend fun beginProject(name: String, project: Project, into: String?): SwitchResult

    /** Opens the saved project [id], or a new empty one if that is gone or null. */
    suspend fun resumeProject(id: String?): SwitchResult

    /** Puts the programs that are there into [world], one that comes with the app, as a project of its own. */
    suspend fun openWorld(world: World): SwitchResult
}

/** What came of opening another project. */
sealed interface SwitchResult {
    /**
     * Another project is open.
     *
     * @property left the id of the project before; null if nothing was changed in it.
     * @property opened the id of the one that is open now; null if nothing of it is saved yet.
     */
    data class Switched(val left: String?, val opened: String?) : SwitchResult

    /** The pupil kept the one that was open, since it could not be saved. */
    data object Kept : SwitchResult
}
