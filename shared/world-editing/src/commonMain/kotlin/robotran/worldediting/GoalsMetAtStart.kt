package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World
import robotran.world.file.outline
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.centre
import robotran.world.geometry.flat

/**
 * The goals of [world] to reach a place where the robot or block is from the start on. To come back at last, or after
 * other goals, is a task, so those are not among them.
 */
fun goalsMetAtStart(world: World): List<ElementRef> = allGoals(world.goals).mapIndexedNotNull { number, (goal, depth) ->
    ElementRef(ElementKind.GOAL, number).takeIf { depth == 0 && isMetAtStart(world, goal) }
}

private fun isMetAtStart(world: World, goal: Goal): Boolean {
    val condition = goal.condition as? GoalCondition.Reach ?: return false
    if (condition.stays) return false
    val region = flat(condition.region)
    val (middle, footprint) = placeOf(world, goal.who) ?: return false
    return if (condition.whole) footprint.isIn(region) else region.contains(middle.x, middle.y)
}

private fun placeOf(world: World, name: String?): Pair<Point, Outline>? {
    val robot = if (name == null) world.robots.firstOrNull() else world.robots.find { it.name == name }
    if (robot != null) {
        return Point(robot.start.x, robot.start.y) to outline(robot.start, robot.description)
    }
    val block = world.blocks.find { it.name == name } ?: return null
    return block.shape.centre to flat(block.shape)
}

private fun Outline.isIn(region: Outline): Boolean {
    val corners = when (this) {
        is Outline.Angular -> corners

        is Outline.Round -> listOf(
            Point(bounds.left, centre.y),
            Point(bounds.right, centre.y),
            Point(centre.x, bounds.bottom),
            Point(centre.x, bounds.top),
        )
    }
    return corners.all { region.contains(it.x, it.y) }
}
