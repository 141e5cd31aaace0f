package robotran.worldediting

import robotran.editing.Editor
import robotran.editing.Gesture
import robotran.language.history.History
import robotran.world.World

/**
 * A world in the editor, with the editor's state. [after] creates the next state.
 *
 * @property selection the selected elements of [world], in the order of selection.
 * @property groups elements that are selected together; each is in at most one group.
 * @property several whether a tap adds to the selection instead of replacing it.
 * @property clipboard the elements copied last.
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
    override val history: History<WorldSnapshot> = History(),
    override val gesture: Gesture<WorldSnapshot, DragHandle>? = null,
    val guides: List<Guide> = emptyList(),
    val error: WorldEditError? = null,
    val errors: List<ValidationError> = emptyList(),
) : Editor<WorldSnapshot, DragHandle, WorldEditing> {
    /** The only selected element; null if there is none or more than one. */
    val only: ElementRef? get() = selection.singleOrNull()

    override val snapshot: WorldSnapshot get() = WorldSnapshot(world, selection, groups)

    override fun isAsIn(snapshot: WorldSnapshot): Boolean = world == snapshot.world

    override fun released(history: History<WorldSnapshot>): WorldEditing =
        copy(gesture = null, guides = emptyList(), history = history, errors = validationErrorsOf(world))

    override fun restored(snapshot: WorldSnapshot, history: History<WorldSnapshot>): WorldEditing = copy(
        world = snapshot.world,
        selection = snapshot.selection,
        groups = snapshot.groups,
        history = history,
        gesture = null,
        guides = emptyList(),
        errors = validationErrorsOf(snapshot.world),
    )

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
