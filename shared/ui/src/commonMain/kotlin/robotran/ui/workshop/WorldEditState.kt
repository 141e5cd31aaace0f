package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.world.World
import robotran.worldediting.WorldEditing

/**
 * The world while it is changed.
 *
 * @property editing the world as it is now, what is chosen, and what can be undone.
 * @property first the world as it was before.
 * @property mendFirst whether somebody wanted to leave although something has to be mended.
 */
@Immutable
data class WorldEditState(
    val editing: WorldEditing,
    val first: World,
    val mendFirst: Boolean = false,
) {
    val world: World get() = editing.world
    val isChanged: Boolean get() = world != first
}
