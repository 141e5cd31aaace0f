package robotran.simulation.goal

import robotran.world.Goal
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Shape
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.outline
import robotran.world.writeThousandths

/** The sentences of a world's goals for its pupils: what the world's author says or, where he says nothing, one made from the goal's figures. */
internal class GoalSentences(
    private val world: World,
    private val trigonometry: Trigonometry,
    private val messages: GoalMessages,
) {
    fun of(goal: Goal): String = goal.says ?: when (goal) {
        is Goal.Reach -> messages.reach(mover(goal.who), region(goal.region), goal.whole, goal.within, goal.stays)
        is Goal.StayOut -> messages.stayOut(mover(goal.who), region(goal.region), goal.whole)
        is Goal.StayIn -> messages.stayIn(mover(goal.who), region(goal.region), goal.whole)
        is Goal.NeverTouch -> messages.neverTouch(mover(goal.who), goal.what.sorted())
        is Goal.DrawTemplate -> messages.drawTemplate(number(goal.tolerance), percent(goal.coverage))
        is Goal.InkLength -> inkLength(goal)
        is Goal.FollowLine -> messages.followLine(mover(goal.who), lineName(goal), isClosed(goal), goal.laps, goal.within)
        is Goal.EndWithin -> messages.endWithin(mover(goal.who), goal.seconds)
        is Goal.ShowOnDisplay -> messages.showOnDisplay(mover(goal.who), goal.text.trim())
        is Goal.PlaySound -> messages.playSound(mover(goal.who), goal.times, goal.lowest, goal.highest)
        is Goal.InOrder -> messages.inOrder()
        is Goal.All -> messages.all()
        is Goal.AnyOf -> messages.anyOf()
    }

    private fun inkLength(goal: Goal.InkLength): String {
        val atLeast = goal.atLeast ?: if (goal.atMost == null) 0.0 else null
        return messages.inkLength(atLeast?.let(::number), goal.atMost?.let(::number))
    }

    private fun mover(who: String?): Mover = when {
        who == null || who == world.robots.first().name -> Mover.OwnRobot
        world.robots.any { it.name == who } -> Mover.OtherRobot(who)
        else -> Mover.Block(who)
    }

    private fun region(shape: Shape): Region {
        val mark = world.marks.find { it.name != null && (it.figure as? MarkFigure.Area)?.shape == shape }
        return Region(mark?.name, place(shape.outline(trigonometry).bounds))
    }

    private fun place(bounds: Bounds): PaperPlace {
        val column = third((bounds.left + bounds.right) / 2, world.paper.width)
        val row = third((bounds.bottom + bounds.top) / 2, world.paper.height)
        return PaperPlace.entries[(THIRDS - 1 - row) * THIRDS + column]
    }

    /** What lies beside the middle fifth is said to be on that side, as people say it. */
    private fun third(middle: Double, side: Double): Int = when {
        middle < side * MIDDLE.start -> 0
        middle > side * MIDDLE.endInclusive -> 2
        else -> 1
    }

    private fun lineName(goal: Goal.FollowLine): String? = goal.line.takeIf { lines().size != 1 }

    private fun isClosed(goal: Goal.FollowLine) =
        lines().find { it.name == goal.line }?.let { (it.figure as MarkFigure.Line).closed } == true

    private fun lines(): List<Mark> = world.marks.filter { it.figure is MarkFigure.Line }

    private fun percent(share: Double) = (share * 100 + 0.5).toInt()

    private companion object {
        const val THIRDS = 3
        val MIDDLE = 0.4..0.6
    }
}

/** As a person writes it, such as `1.5` or `20`. */
internal fun number(value: Double): String = writeThousandths(value).removeSuffix(".0")
