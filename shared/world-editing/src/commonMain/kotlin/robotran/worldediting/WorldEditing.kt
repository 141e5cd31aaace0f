package robotran.worldediting

import robotran.world.World
import robotran.world.geometry.Point

/**
 * A world that is being edited, and all that belongs to that. [after] makes the next of it.
 *
 * @property selection what is chosen, in the order of choosing; always things of [world].
 * @property groups things that are chosen together; none is in two groups.
 * @property several whether what is tapped is chosen beside what was, instead of it.
 * @property clipboard what was copied last.
 * @property gesture what somebody holds at the moment.
 * @property guides what the thing that is being moved was drawn to.
 * @property error why the last thing wanted was not done; null if it was.
 * @property errors what has to be mended before the world can be kept.
 */
data class WorldEditing(
    val world: World,
    val selection: Set<ElementRef> = emptySet(),
    val groups: List<Set<ElementRef>> = emptyList(),
    val tool: Tool = Tool.CHOOSE,
    val several: Boolean = false,
    val snapping: Snapping = Snapping(),
    val clipboard: List<Element> = emptyList(),
    val history: History = History(),
    val gesture: Gesture? = null,
    val guides: List<Guide> = emptyList(),
    val error: EditError? = null,
    val errors: List<ValidationError> = emptyList(),
) {
    /** The one thing that is chosen; null if there is none or more than one. */
    val only: ElementRef? get() = selection.singleOrNull()

    internal val moment: Moment get() = Moment(world, selection, groups)

    companion object {
        fun of(world: World) = WorldEditing(world, errors = troublesOf(world))
    }
}

/** What a finger on the sheet does. */
enum class Tool {
    /** Chooses and moves. */
    CHOOSE,

    /** Draws a line to be traced. */
    DRAW_TEMPLATE,

    /** Draws a line that is printed on the paper. */
    DRAW_LINE,
}

/**
 * Somebody holds [grip] since it was at [from], and then things were as in [before].
 */
data class Gesture(val grip: DragHandle, val from: Point, val before: Moment)
