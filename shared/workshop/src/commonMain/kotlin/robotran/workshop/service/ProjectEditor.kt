package robotran.workshop.service

import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.world.World

/** Changes what is open. */
interface ProjectEditor {
    /** Opens [project] in place of all that is there; programs and run begin afresh. */
    fun openProject(project: Project)

    /**
     * Puts the same robots and programs into [world]; the run begins afresh.
     *
     * @param isAnother whether it is not the world before with changes.
     */
    fun changeWorld(world: World, isAnother: Boolean = false)

    /**
     * From now on [world] is what would be saved, while robots still drive in the one before; [changeWorld] puts them
     * into it.
     */
    fun keepWorld(world: World)

    /** Changes how the programs run; the run begins afresh. */
    fun changeProjectSettings(settings: ProjectSettings)
}
