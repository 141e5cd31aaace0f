package robotran.workshop.world

import robotran.projects.Project
import robotran.workshop.service.AssignmentRepository
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProjectEditor
import robotran.workshop.state.EditOrigin
import robotran.world.World

/** The project as the world editor sees it: while the author edits a variation, with that in place of the world. */
internal class VariationTarget(
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val assignments: AssignmentRepository,
) : CurrentProject by current,
    ProjectEditor by editor {
    /** The index of the variation that is edited; null for the world itself. */
    var variation: Int? = null
        private set

    /** What the editor tells about where it leads back to; null if that is the workshop. */
    var origin: EditOrigin? = null
        private set

    /** The editor is going to be opened from the page of the assignment, for the world or [variation]. */
    fun comeFromAssignment(variation: Int?) {
        val own = current.project
        this.variation = variation
        origin = EditOrigin(own.world.title, variation?.let { own.assignment?.checks?.variations?.getOrNull(it)?.name })
    }

    /** The editor is closed. */
    fun leave() {
        variation = null
        origin = null
    }

    override val project: Project
        get() {
            val own = current.project
            val index = variation ?: return own
            return own.assignment?.checks?.variations?.getOrNull(index)?.let { own.copy(world = it.world) } ?: own
        }

    override fun changeWorld(world: World, isAnother: Boolean) {
        if (variation == null) editor.changeWorld(world, isAnother) else saveVariation(world)
    }

    override fun saveWorld(world: World) {
        if (variation == null) editor.saveWorld(world) else saveVariation(world)
    }

    private fun saveVariation(world: World) {
        val assignment = current.project.assignment ?: return
        val checks = assignment.checks ?: return
        val variations = checks.variations.mapIndexed { index, old ->
            if (index == variation) old.copy(world = world) else old
        }
        assignments.changeAssignment(assignment.copy(checks = checks.copy(variations = variations)))
    }
}
