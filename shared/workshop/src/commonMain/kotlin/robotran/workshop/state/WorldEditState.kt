package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.world.World
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEditing
import robotran.worldediting.goalsMetAtStart

/**
 * The state of the world editor.
 *
 * @property editing the edited world, the selection and the undo history.
 * @property first the world before editing.
 * @property origin the assignment to which the editor leads back; null if it leads back to the workshop.
 * @property hasFailedToClose whether the user tried to close the editor with an invalid world.
 * @property hintsShown whether validation messages are shown; false once the user has closed them.
 */
@Immutable
data class WorldEditState(
    val editing: WorldEditing,
    val first: World,
    val origin: EditOrigin? = null,
    val hasFailedToClose: Boolean = false,
    val hintsShown: Boolean = true,
) {
    val world: World get() = editing.world
    val isChanged: Boolean get() = world != first

    /** The goals where somebody already is at the start, so that nothing has to be done for them. */
    val metAtStart: List<ElementRef> = goalsMetAtStart(editing.world)
}

/** The assignment called [assignment] whose world is edited, or its variation called [variation]. */
data class EditOrigin(val assignment: String, val variation: String?)
