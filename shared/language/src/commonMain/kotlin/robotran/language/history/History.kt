package robotran.language.history

/**
 * The undo and redo stacks of anything that is edited. They are immutable: each call returns a new history. Beyond
 * [MAX_STEPS], the oldest steps are dropped.
 *
 * @param T a step: either the state before it, or the change itself.
 * @property past the steps to undo, the oldest first.
 * @property future the undone steps, the one to redo next last.
 * @property mergeKey the ongoing change, such as typing a name, whose next part is no step of its own; null if there is
 * none.
 */
data class History<T>(val past: List<T> = emptyList(), val future: List<T> = emptyList(), val mergeKey: Any? = null) {
    val canUndo: Boolean get() = past.isNotEmpty()
    val canRedo: Boolean get() = future.isNotEmpty()

    /** The history with another [step], unless it only continues the change with the same [mergeKey]. */
    fun recorded(step: T, mergeKey: Any? = null): History<T> = if (mergeKey != null && mergeKey == this.mergeKey) {
        copy(future = emptyList())
    } else {
        History((past + step).takeLast(MAX_STEPS), emptyList(), mergeKey)
    }

    /** The history whose next step is one of its own. */
    fun mergeEnded(): History<T> = if (mergeKey == null) this else copy(mergeKey = null)

    /**
     * The step to undo and the history without it; null if there is none.
     *
     * @param redo the step that redoes it: where a step is a state, the state now.
     */
    fun undone(redo: (T) -> T): Pair<T, History<T>>? =
        past.lastOrNull()?.let { it to History(past.dropLast(1), future + redo(it)) }

    /**
     * The step to redo and the history with it; null if there is none.
     *
     * @param undo the step that undoes it: where a step is a state, the state now.
     */
    fun redone(undo: (T) -> T): Pair<T, History<T>>? =
        future.lastOrNull()?.let { it to History(past + undo(it), future.dropLast(1)) }

    companion object {
        const val MAX_STEPS = 200
    }
}
