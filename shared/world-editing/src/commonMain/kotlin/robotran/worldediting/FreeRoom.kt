package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World
import robotran.world.geometry.Bounds

/**
 * [form] at the place nearest to its own where it is whole on the paper and lies over nothing else, if possible whole
 * [inSight]; null if there is no such place, or if [element] is meant to lie around others.
 */
internal fun World.inFreeRoom(element: Element, form: Form, inSight: Bounds): Form? {
    if (element.liesAround) return null
    val others = things().mapNotNull(::piece).filter { !it.liesAround && !it.isGround }
        .mapNotNull { it.form?.bounds?.grownBy(AIR) }
    val free = STEPS_NEARBY.asSequence().map { (x, y) -> form.movedBy(x * STEP, y * STEP) }.filter { moved ->
        val bounds = moved.bounds
        isOnPaper(bounds) && others.none { meet(bounds, it) }
    }
    return free.firstOrNull { it.bounds in inSight } ?: free.firstOrNull()
}

private fun World.isOnPaper(bounds: Bounds) =
    bounds.left >= 0 && bounds.bottom >= 0 && bounds.right <= paper.width && bounds.top <= paper.height

/** A robot is to be in it from the start on. */
private val Element.liesAround: Boolean
    get() = ((this as? Element.OfGoal)?.goal)?.let(::isPermittedArea) == true

private fun isPermittedArea(goal: Goal) = goal.condition is GoalCondition.StayIn

/** A grey map is mostly the whole ground of a world. */
private val Element.isGround: Boolean get() = form is Form.Picture

internal fun meet(one: Bounds, other: Bounds) =
    one.left < other.right && other.left < one.right && one.bottom < other.top && other.bottom < one.top

/** Steps across and up, the shortest way first. */
private val STEPS_NEARBY: List<Pair<Int, Int>> by lazy {
    val steps = -MOST_STEPS..MOST_STEPS
    steps.flatMap { x -> steps.map { y -> x to y } }.sortedBy { (x, y) -> x * x + y * y }
}

/** A multiple of every grid up to 5 cm, so that what lies on the grid stays on it. */
private const val STEP = 5.0
private const val MOST_STEPS = 24

/** Between one element and the next, in centimetres. */
private const val AIR = 2.0
