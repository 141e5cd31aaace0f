package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.world.World
import robotran.worldediting.WorldEditing

/**
 * The world while it is changed.
 *
 * @property editing the world as it is now, what is chosen, and what can be undone.
 * @property first the world as it was before.
 * @property mendFirst whether somebody wanted to leave although something has to be mended.
 * @property hintsShown whether it is told why something was not done, or what has to be mended; false once somebody has
 * put that away.
 */
@Immutable
data class WorldEditState(
    val editing: WorldEditing,
    val first: World,
    val mendFirst: Boolean = false,
    val hintsShown: Boolean = true,
) {
    val world: World get() = editing.world
    val isChanged: Boolean get() = world != first
}
