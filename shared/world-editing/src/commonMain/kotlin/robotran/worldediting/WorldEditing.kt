package robotran.worldediting

import robotran.language.history.History
import robotran.world.World
import robotran.world.geometry.Point

/**
 * A world in the editor, with the editor's state. [after] creates the next state.
 *
 * @property selection the selected elements of [world], in the order of selection.
 * @property groups elements that are selected together; each is in at most one group.
 * @property several whether a tap adds to the selection instead of replacing it.
 * @property clipboard the elements copied last.
 * @property gesture the current drag.
 * @property guides the lines that the dragged element has snapped to.
 * @property error why the last edit was rejected; null if it was not.
 * @property errors what must be fixed before the world can be saved.
 */
data class WorldEditing(
    val world: World,
    val selection: Set<ElementRef> = emptySet(),
    val groups: List<Set<ElementRef>> = emptyList(),
    val tool: Tool = Tool.SELECT,
    val isMultiSelect: Boolean = false,
    val snapping: Snapping = Snapping(),
    val clipboard: List<Element> = emptyList(),
    val history: History<WorldSnapshot> = History(),
    val gesture: Gesture? = null,
    val guides: List<Guide> = emptyList(),
    val error: WorldEditError? = null,
    val errors: List<ValidationError> = emptyList(),
) {
    /** The only selected element; null if there is none or more than one. */
    val only: ElementRef? get() = selection.singleOrNull()

    internal val snapshot: WorldSnapshot get() = WorldSnapshot(world, selection, groups)

    companion object {
        fun of(world: World) = WorldEditing(world, errors = validationErrorsOf(world))
    }
}

/** The function of a pointer on the sheet. */
enum class Tool {
    /** Selects and moves. */
    SELECT,

    /** Draws a line of the template. */
    DRAW_TEMPLATE,

    /** Draws a line that is printed on the paper. */
    DRAW_LINE,
}

/** The user drags [grip] from [from]; [before] is the state at the start. */
data class Gesture(val grip: DragHandle, val from: Point, val before: WorldSnapshot)
