package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.world.World

/**
 * The world while it is changed.
 *
 * @property world as it is now.
 */
@Immutable
data class WorldEditState(val world: World)
