package robotran.simulation

import robotran.simulation.goal.Actor
import robotran.simulation.goal.ObjectLocations
import robotran.simulation.goal.meets
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.length
import robotran.world.geometry.outline

/** Finds free space for a block that the user puts down. */
internal class FreeSpaceFinder(private val world: World, trigonometry: Trigonometry) {
    private val places = ObjectLocations(world, trigonometry)
    private val solids = world.walls.map { it.outline() } + world.barriers.map { it.shape.outline(trigonometry) }
    private val directions = List(DIRECTIONS) {
        val angle = it * 2 * kotlin.math.PI / DIRECTIONS
        Point(trigonometry.cosine(angle), trigonometry.sine(angle))
    }

    /**
     * The offset for a block so that it lies as close as possible to where [moved] puts it, without overlapping
     * anything; [moved] itself if there is no free space within [FARTHEST] centimetres.
     *
     * @param robots the poses of the robots.
     * @param blocks the offsets of the blocks.
     */
    fun nearest(block: Int, moved: Pose, robots: List<Pose>, blocks: List<Pose>): Pose {
        val others = solids + robots.mapIndexed { number, pose -> places.footprint(Actor.OfRobots(number), pose) } +
            blocks.indices.filter { it != block }.map { places.footprint(Actor.OfBlocks(it), blocks[it]) }
        return sequenceOf(moved).plus(around(moved)).firstOrNull { isFree(block, it, others) } ?: moved
    }

    private fun around(moved: Pose): Sequence<Pose> = (1..(FARTHEST / STEP).toInt()).asSequence().flatMap { ring ->
        directions.asSequence().map { moved.copy(x = moved.x + ring * STEP * it.x, y = moved.y + ring * STEP * it.y) }
    }

    private fun isFree(block: Int, moved: Pose, others: List<Outline>): Boolean {
        val middle = places.blockCentre(block, moved)
        if (!world.paper.contains(middle.x, middle.y)) return false
        val outline = places.footprint(Actor.OfBlocks(block), moved)
        return others.none { outline.meets(it) }
    }

    private companion object {
        const val DIRECTIONS = 16
        const val STEP = 0.5
        const val FARTHEST = 40.0
    }
}

private fun Wall.outline(): Outline {
    val along = length(to.x - from.x, to.y - from.y)
    val reachX = if (along == 0.0) thickness / 2 else (to.x - from.x) / along * thickness / 2
    val reachY = if (along == 0.0) 0.0 else (to.y - from.y) / along * thickness / 2
    return Outline.Angular(
        listOf(
            Point(from.x - reachX + reachY, from.y - reachY - reachX),
            Point(
                to.x + reachX + reachY,
                to.y + reachY - reachX,
            ),
            Point(to.x + reachX - reachY, to.y + reachY + reachX),
            Point(
                from.x - reachX - reachY,
                from.y - reachY + reachX,
            ),
        ),
    )
}
