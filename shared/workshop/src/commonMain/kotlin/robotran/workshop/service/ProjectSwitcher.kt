package robotran.workshop.service

import robotran.brick.kind.BrickKind
import robotran.projects.Project
import robotran.world.World

/** Opens another project. The current one stays saved. Asks before changes are lost. */
interface ProjectSwitcher {
    /** The ID of the open project; null until it is first saved. */
    val openId: String?

    /**
     * Opens [project].
     *
     * @param into the ID of the saved project it replaces; if there is none, a new project [name] is created.
     */
    suspend fun beginProject(name: String, project: Project, into: String?): SwitchResult

    /** Opens the saved project [id], or a new empty one for a [brick] if it is missing or null. */
    suspend fun resumeProject(id: String?, brick: BrickKind): SwitchResult

    /**
     * Opens [project] as a new project [name] to look at. It is not kept if it is left unchanged.
     *
     * @return [SwitchResult.Switched.previousId] is the ID of the previous project, even if that is not kept;
     * [SwitchResult.Switched.currentId] is null only if the project cannot be saved.
     */
    suspend fun previewProject(name: String, project: Project): SwitchResult

    /** Opens the saved project [id] again after a visit, or [project] as a new project [name] if it was not kept. */
    suspend fun returnTo(id: String?, name: String, project: Project): SwitchResult

    /** Opens the built-in [world] with the current programs as a new project. */
    suspend fun openWorld(world: World): SwitchResult
}

/** The result of opening another project. */
sealed interface SwitchResult {
    /**
     * Another project is open.
     *
     * @property previousId the ID of the previous project; null if it was unchanged.
     * @property currentId the ID of the open project; null if it is not saved yet.
     */
    data class Switched(val previousId: String?, val currentId: String?) : SwitchResult

    /** The pupil kept the open project, since it could not be saved. */
    data object Cancelled : SwitchResult
}
