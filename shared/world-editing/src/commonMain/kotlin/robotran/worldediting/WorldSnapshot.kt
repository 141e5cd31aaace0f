package robotran.worldediting

import robotran.world.World

/** The state that undo restores. */
data class WorldSnapshot(val world: World, val selection: Set<ElementRef>, val groups: List<Set<ElementRef>>)
