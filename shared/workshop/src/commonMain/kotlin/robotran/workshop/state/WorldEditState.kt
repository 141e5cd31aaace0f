package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.world.World
import robotran.worldediting.WorldEditing

/**
 * The state of the world editor.
 *
 * @property editing the edited world, the selection and the undo history.
 * @property first the world before editing.
 * @property hasFailedToClose whether the user tried to close the editor with an invalid world.
 * @property hintsShown whether validation messages are shown; false once the user has closed them.
 */
@Immutable
data class WorldEditState(
    val editing: WorldEditing,
    val first: World,
    val hasFailedToClose: Boolean = false,
    val hintsShown: Boolean = true,
) {
    val world: World get() = editing.world
    val isChanged: Boolean get() = world != first
}
