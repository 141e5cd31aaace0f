package robotran.worldediting

import robotran.world.World

/** The state that undo restores. */
data class Moment(val world: World, val selection: Set<ElementRef>, val groups: List<Set<ElementRef>>)

/**
 * The undo and redo stacks.
 *
 * @property going the ongoing change, such as typing a name, whose next part is no separate undo step; null if there is
 * none.
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
        /** Max number of undo steps. */
        const val MAX_STEPS = 200
    }
}
