package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/** A template goal of each kind; one that refers to a line still needs the line's name. */
fun newGoals(world: World): List<Goal> {
    val region = Shape.Rectangle(Point(world.paper.width * PLACE, world.paper.height / 2), REGION, REGION)
    val sound = GoalCondition.PlaySound()
    return listOf(
        GoalCondition.Reach(region),
        GoalCondition.StayOut(region),
        GoalCondition.StayIn(region),
        GoalCondition.NeverTouch(),
        GoalCondition.DrawTemplate(),
        GoalCondition.InkLength(DEFAULT_INK, null),
        GoalCondition.FollowLine(line = "-"),
        GoalCondition.EndWithin(world.timeLimit),
        GoalCondition.ShowOnDisplay("42"),
        sound,
        GoalCondition.InOrder(listOf(Goal(sound))),
        GoalCondition.All(listOf(Goal(sound))),
        GoalCondition.AnyOf(listOf(Goal(sound))),
    ).map { Goal(it) }
}

private const val PLACE = 0.75
private const val REGION = 20.0

/** The length of a line that a goal begins with, in centimetres. */
internal const val DEFAULT_INK = 40.0
