package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point

/** A change of a world or of its selected elements by the user. Positions are on the paper, in centimetres. */
sealed interface Edit {
    // Selecting.

    /**
     * Selects the element within [reach] of [place], or the one below it if that is already selected; clears the
     * selection if there is none.
     */
    data class TapAt(val place: Point, val reach: Double, val adding: Boolean = false) : Edit

    /** null clears the selection. */
    data class Select(val thing: ElementRef?, val adding: Boolean = false) : Edit

    data class SelectWithin(val area: Bounds, val adding: Boolean = false) : Edit

    data object SelectAll : Edit

    data class SelectNext(val backwards: Boolean = false) : Edit

    // Dragging.

    data class StartDrag(val grip: DragHandle, val at: Point) : Edit

    /** @property reach max distance of snapping to other elements. */
    data class DragTo(val at: Point, val reach: Double) : Edit

    data object Drop : Edit

    /** Cancels the drag. */
    data object CancelDrag : Edit

    /** Draws a line with [Tool.DRAW_TEMPLATE] or [Tool.DRAW_LINE]. */
    data class Draw(val points: List<Point>) : Edit

    // Changes of the selection.

    data class Nudge(val x: Double, val y: Double) : Edit

    data class TurnBy(val degrees: Double) : Edit

    data class ScaleBy(val factor: Double) : Edit

    data object Duplicate : Edit

    data object Delete : Edit

    data object Copy : Edit

    /** @property at the position; null for next to the original. */
    data class Paste(val at: Point? = null) : Edit

    data object Group : Edit

    data object Ungroup : Edit

    /** With each other, or a single element with the paper. */
    data class Align(val side: AlignSide) : Edit

    /** Changes the order of overlapping marks. */
    data class Restack(val order: StackOrder) : Edit

    // Changes of one element.

    /** @property at the desired position; the nearest free space is used. */
    data class Put(val piece: Element, val at: Point) : Edit

    /** Replaces [thing] by [piece], of the same kind; rounds its numbers as in a file. */
    data class Change(val thing: ElementRef, val piece: Element) : Edit

    data class MoveCorner(val thing: ElementRef, val number: Int, val to: Point) : Edit

    /** Adds a corner in the middle between the corner [after] and the next. */
    data class AddCorner(val thing: ElementRef, val after: Int) : Edit

    data class RemoveCorner(val thing: ElementRef, val number: Int) : Edit

    /** Converts a rectangle or circle to a polygon with movable corners. */
    data class MakeCorners(val thing: ElementRef) : Edit

    // Changes of goals, by their index.

    /** @property into the index of its group; null for none. */
    data class AddGoal(val goal: Goal, val into: Int? = null) : Edit

    data class MoveGoal(val number: Int, val move: GoalMove) : Edit

    /** Puts a goal into a new group. */
    data class WrapGoal(val number: Int, val group: GoalGroup) : Edit

    /** Removes a group and keeps its goals. */
    data class UnwrapGoal(val number: Int) : Edit

    // Changes of the whole world.

    data class ChangeSheet(val figures: SheetProperties) : Edit

    /** Keeps nothing but [title] and one robot. */
    data class NewWorld(val title: String) : Edit

    // Changes of the editor.

    data class SelectTool(val tool: Tool) : Edit

    data class SelectSeveral(val several: Boolean) : Edit

    data class Snap(val snapping: Snapping) : Edit

    /** Ends a change by typing or with a slider; the next one is a separate undo step. */
    data object FinishChange : Edit

    /** Applies all of these as one undo step. */
    data class Batch(val edits: List<Edit>) : Edit

    data object Undo : Edit

    data object Redo : Edit
}

enum class AlignSide { LEFT, CENTRE, RIGHT, TOP, MIDDLE, BOTTOM }

enum class StackOrder { TO_BACK, BACK, FORWARD, TO_FRONT }

/**
 * The directions in which a goal moves in the list: before or after its neighbour, into the group before it, or out of
 * its group.
 */
enum class GoalMove { UP, DOWN, IN, OUT }

/** The kinds of groups. */
enum class GoalGroup(private val groupOf: (List<Goal>) -> GoalCondition) {
    IN_ORDER(GoalCondition::InOrder),
    ALL(GoalCondition::All),
    ANY_OF(GoalCondition::AnyOf),
    ;

    /** The group that contains only [goal]. */
    fun around(goal: Goal): GoalCondition = groupOf(listOf(goal))
}
