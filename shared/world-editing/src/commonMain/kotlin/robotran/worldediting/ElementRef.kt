package robotran.worldediting

/**
 * Something in a world that can be chosen.
 *
 * @property number which of its kind it is, from 0, in the world's own order; strokes and goals as [strokes] and
 * [allGoals] count them.
 */
data class ElementRef(val kind: ElementKind, val number: Int)

/** What kinds of things a world has, in the order in which they lie over one another, the lowest first. */
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
