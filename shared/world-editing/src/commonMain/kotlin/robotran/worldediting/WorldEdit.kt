package robotran.worldediting

import robotran.editing.CommonEdits
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point

/** A change of a world or of its selected elements by the user. Positions are on the paper, in centimetres. */
sealed interface WorldEdit {
    // Selecting.

    /**
     * Selects the element within [reach] of [place], or the one below it if that is already selected; clears the
     * selection if there is none.
     */
    data class TapAt(val place: Point, val reach: Double, val adding: Boolean = false) : WorldEdit

    /** null clears the selection. */
    data class Select(val thing: ElementRef?, val adding: Boolean = false) : WorldEdit

    data class SelectWithin(val area: Bounds, val adding: Boolean = false) : WorldEdit

    data object SelectAll : WorldEdit

    data class SelectNext(val backwards: Boolean = false) : WorldEdit

    // Dragging.

    data class StartDrag(val grip: DragHandle, val at: Point) : WorldEdit

    /** @property reach max distance of snapping to other elements. */
    data class DragTo(val at: Point, val reach: Double) : WorldEdit

    data object Drop : WorldEdit

    /** Cancels the drag. */
    data object CancelDrag : WorldEdit

    /** Draws a line with [Tool.DRAW_TEMPLATE] or [Tool.DRAW_LINE]. */
    data class Draw(val points: List<Point>) : WorldEdit

    // Changes of the selection.

    data class Nudge(val x: Double, val y: Double) : WorldEdit

    data class TurnBy(val degrees: Double) : WorldEdit

    data class ScaleBy(val factor: Double) : WorldEdit

    data object Duplicate : WorldEdit

    data object Delete : WorldEdit

    data object Copy : WorldEdit

    /** @property at the position; null for next to the original. */
    data class Paste(val at: Point? = null) : WorldEdit

    data object Group : WorldEdit

    data object Ungroup : WorldEdit

    /** With each other, or a single element with the paper. */
    data class Align(val side: AlignSide) : WorldEdit

    /** Changes the order of overlapping marks. */
    data class Restack(val order: StackOrder) : WorldEdit

    // Changes of one element.

    /**
     * @property at the desired position. What stands is put into the nearest free space.
     * @property inSight the part of the sheet that is seen if nobody has chosen the place: then everything is put where
     * there is nothing else, and there if possible.
     */
    data class Put(val piece: Element, val at: Point, val inSight: Bounds? = null) : WorldEdit

    /** Replaces [thing] by [piece], of the same kind; rounds its numbers as in a file. */
    data class Change(val thing: ElementRef, val piece: Element) : WorldEdit

    data class MoveCorner(val thing: ElementRef, val number: Int, val to: Point) : WorldEdit

    /** Adds a corner in the middle between the corner [after] and the next. */
    data class AddCorner(val thing: ElementRef, val after: Int) : WorldEdit

    data class RemoveCorner(val thing: ElementRef, val number: Int) : WorldEdit

    /** Converts a rectangle or circle to a polygon with movable corners. */
    data class MakeCorners(val thing: ElementRef) : WorldEdit

    // Changes of goals, by their index.

    /** @property into the index of its group; null for none. */
    data class AddGoal(val goal: Goal, val into: Int? = null) : WorldEdit

    data class MoveGoal(val number: Int, val move: GoalMove) : WorldEdit

    /** Puts a goal into a new group. */
    data class WrapGoal(val number: Int, val group: GoalGroup) : WorldEdit

    /** Removes a group and keeps its goals. */
    data class UnwrapGoal(val number: Int) : WorldEdit

    // Changes of the whole world.

    data class ChangeSheet(val parameters: SheetProperties) : WorldEdit

    /** Keeps nothing but [title] and one robot. */
    data class NewWorld(val title: String) : WorldEdit

    // Changes of the editor.

    data class SelectTool(val tool: Tool) : WorldEdit

    data class SetMultiSelect(val isMultiSelect: Boolean) : WorldEdit

    data class Snap(val snapping: Snapping) : WorldEdit

    /** Ends a change by typing or with a slider; the next one is a separate undo step. */
    data object FinishChange : WorldEdit

    /** Applies all of these as one undo step. */
    data class Batch(val edits: List<WorldEdit>) : WorldEdit

    data object Undo : WorldEdit

    data object Redo : WorldEdit

    companion object {
        val COMMON: CommonEdits<WorldEdit> = CommonEdits(Undo, Redo, FinishChange, Drop, CancelDrag)
    }
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
