package robotran.worldediting

import robotran.world.World

/** What undoing brings back. */
data class Moment(val world: World, val selection: Set<ElementRef>, val groups: List<Set<ElementRef>>)

/**
 * What was before, the latest last, and what was undone, the next to come back last.
 *
 * @property going what the latest change is a part of, such as typing a name: the next part of it is no step of its
 * own. Null if it is done.
 */
data class History(
    val past: List<Moment> = emptyList(),
    val future: List<Moment> = emptyList(),
    val going: Any? = null,
) {
    val canUndo: Boolean get() = past.isNotEmpty()
    val canRedo: Boolean get() = future.isNotEmpty()

    internal fun changed(before: Moment, part: Any?): History = if (part != null && part == going) {
        copy(future = emptyList())
    } else {
        History((past + before).takeLast(MAX_STEPS), emptyList(), part)
    }

    internal fun settled(): History = if (going == null) this else copy(going = null)

    companion object {
        /** How many steps can be undone. */
        const val MAX_STEPS = 200
    }
}
