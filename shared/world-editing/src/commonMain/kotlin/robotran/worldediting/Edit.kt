package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point

/**
 * Something that a person wants to be done to a world or to what is chosen of it. Places are on the paper, in
 * centimetres.
 */
sealed interface Edit {
    // Choosing.

    /**
     * What is within [reach] of [place] is chosen, or if it was already, what lies below it; nothing, if nothing is
     * there.
     */
    data class TapAt(val place: Point, val reach: Double, val adding: Boolean = false) : Edit

    /** Null for choosing nothing. */
    data class Choose(val thing: ElementRef?, val adding: Boolean = false) : Edit

    data class ChooseWithin(val area: Bounds, val adding: Boolean = false) : Edit

    data object ChooseAll : Edit

    data class ChooseNext(val backwards: Boolean = false) : Edit

    // By finger or mouse.

    data class Grab(val grip: DragHandle, val at: Point) : Edit

    /** @property reach how near something must come to others to be drawn to them. */
    data class DragTo(val at: Point, val reach: Double) : Edit

    data object Drop : Edit

    /** What is held goes back to where it was. */
    data object LetGo : Edit

    /** A line was drawn with [Tool.DRAW_TEMPLATE] or [Tool.DRAW_LINE]. */
    data class Draw(val points: List<Point>) : Edit

    // With what is chosen.

    data class Nudge(val x: Double, val y: Double) : Edit

    data class TurnBy(val degrees: Double) : Edit

    data class ScaleBy(val factor: Double) : Edit

    data object Duplicate : Edit

    data object Delete : Edit

    data object Copy : Edit

    /** @property at where to; null for beside where it was. */
    data class Paste(val at: Point? = null) : Edit

    data object Group : Edit

    data object Ungroup : Edit

    /** With each other, or a single thing with the paper. */
    data class Align(val side: AlignSide) : Edit

    /** Marks lie one over the other. */
    data class Restack(val order: StackOrder) : Edit

    // With one thing.

    /** @property at about where; there is made room for it. */
    data class Put(val piece: Element, val at: Point) : Edit

    /** [thing] is to be like [piece], of the same kind; its numbers are rounded to what a file keeps. */
    data class Change(val thing: ElementRef, val piece: Element) : Edit

    data class MoveCorner(val thing: ElementRef, val number: Int, val to: Point) : Edit

    /** One more in the middle between the corner [after] and the next. */
    data class AddCorner(val thing: ElementRef, val after: Int) : Edit

    data class RemoveCorner(val thing: ElementRef, val number: Int) : Edit

    /** A rectangle or circle becomes a polygon, whose corners can be moved. */
    data class MakeCorners(val thing: ElementRef) : Edit

    // Goals, by their number.

    /** @property into the group that it is put into; null for none. */
    data class AddGoal(val goal: Goal, val into: Int? = null) : Edit

    data class MoveGoal(val number: Int, val move: GoalMove) : Edit

    /** A group is put round a goal. */
    data class WrapGoal(val number: Int, val group: GoalGroup) : Edit

    /** A group goes, and its goals stay. */
    data class UnwrapGoal(val number: Int) : Edit

    // The world as a whole.

    data class ChangeSheet(val figures: SheetFigures) : Edit

    /** Nothing is kept but [title] and one robot. */
    data class NewWorld(val title: String) : Edit

    // How to edit.

    data class ChooseTool(val tool: Tool) : Edit

    data class ChooseSeveral(val several: Boolean) : Edit

    data class Snap(val snapping: Snapping) : Edit

    /** A change by typing or with a slider is done; the next is a step of its own. */
    data object FinishChange : Edit

    /** All of these as one step. */
    data class Batch(val edits: List<Edit>) : Edit

    data object Undo : Edit

    data object Redo : Edit
}

enum class AlignSide { LEFT, CENTRE, RIGHT, TOP, MIDDLE, BOTTOM }

enum class StackOrder { TO_BACK, BACK, FORWARD, TO_FRONT }

/**
 * How a goal changes its place in the list: before or behind its neighbour, into the group before it, or out of the
 * group that it is in.
 */
enum class GoalMove { UP, DOWN, IN, OUT }

/** What a goal can be put into. */
enum class GoalGroup(private val groupOf: (List<Goal>) -> GoalCondition) {
    IN_ORDER(GoalCondition::InOrder),
    ALL(GoalCondition::All),
    ANY_OF(GoalCondition::AnyOf),
    ;

    /** The group with nothing but [goal]. */
    fun around(goal: Goal): GoalCondition = groupOf(listOf(goal))
}
