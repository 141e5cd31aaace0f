package robotran.editing

/**
 * The edits that every editor has.
 *
 * @property finish ends a change by typing or with a slider; the next one is a separate undo step.
 * @property cancelDrag ends a drag and restores what was before.
 */
class CommonEdits<T : Any>(val undo: T, val redo: T, val finish: T, val drop: T, val cancelDrag: T)
