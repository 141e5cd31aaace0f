package robotran.simulation.goal

import robotran.simulation.messages.Mover
import robotran.simulation.messages.PaperSector
import robotran.simulation.messages.Region
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Shape
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.outline

/** Names the objects in the sentences of goals. */
internal class SentenceParts(private val world: World, private val trigonometry: Trigonometry) {
    fun mover(who: String?): Mover = when {
        who == null || who == world.robots.first().name -> Mover.OwnRobot
        world.robots.any { it.name == who } -> Mover.OtherRobot(who)
        else -> Mover.Block(who)
    }

    fun region(shape: Shape): Region {
        val mark = world.marks.find { it.name != null && (it.figure as? MarkFigure.Area)?.shape == shape }
        return Region(mark?.name, place(shape.outline(trigonometry).bounds))
    }

    /** The name of the line; null if there is only one. */
    fun lineName(line: String): String? = line.takeIf { lines().size != 1 }

    fun isClosed(line: String): Boolean =
        lines().find { it.name == line }?.let { (it.figure as MarkFigure.Line).closed } == true

    private fun place(bounds: Bounds): PaperSector {
        val column = third((bounds.left + bounds.right) / 2, world.paper.width)
        val row = third((bounds.bottom + bounds.top) / 2, world.paper.height)
        return PaperSector.entries[(THIRDS - 1 - row) * THIRDS + column]
    }

    /** Everything outside the middle fifth counts as a side, as in everyday language. */
    private fun third(middle: Double, side: Double): Int = when {
        middle < side * MIDDLE.start -> 0
        middle > side * MIDDLE.endInclusive -> 2
        else -> 1
    }

    private fun lines(): List<Mark> = world.marks.filter { it.figure is MarkFigure.Line }

    private companion object {
        const val THIRDS = 3
        val MIDDLE = 0.4..0.6
    }
}

internal fun percent(share: Double): Int = (share * 100 + 0.5).toInt()
