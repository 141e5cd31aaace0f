package robotran.workshop.service

import robotran.documents.SavedBreakpoint
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.world.World

/** Changes the open project. */
interface ProjectEditor {
    /** Replaces the open project by [project] and starts a new run. */
    fun openProject(project: Project)

    /** Sets the breakpoints of the open project; those of what it does not have are left out. */
    fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) = Unit

    /**
     * Puts the same robots and programs into [world] and starts a new run.
     *
     * @param isAnother whether it is a different world, not an edited one.
     */
    fun changeWorld(world: World, isAnother: Boolean = false)

    /** Saves [world] from now on, while robots still drive in the previous one until [changeWorld]. */
    fun saveWorld(world: World)

    /** Changes how programs run and starts a new run. */
    fun changeProjectSettings(settings: ProjectSettings)
}
