package robotran.worldediting

/**
 * Refers to a selectable element of a world.
 *
 * @property number its index among those of its kind, in the world's order; for strokes and goals as in [strokes] and
 * [allGoals].
 */
data class ElementRef(val kind: ElementKind, val number: Int)

/** The kinds of elements, in drawing order from the bottom up. */
enum class ElementKind {
    MARK,
    STROKE,
    GOAL,
    WALL,
    BARRIER,
    BLOCK,
    ROBOT,
    LAMP,
}
