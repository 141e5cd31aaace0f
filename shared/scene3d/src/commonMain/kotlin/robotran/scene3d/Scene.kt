package robotran.scene3d

import robotran.scene3d.geometry.ConvexPolygon
import robotran.scene3d.model.Body
import robotran.scene3d.model.Heights
import robotran.scene3d.model.Placement
import robotran.scene3d.model.RobotFace
import robotran.scene3d.model.RobotModel
import robotran.scene3d.model.Round
import robotran.scene3d.model.SceneColours
import robotran.scene3d.model.SceneElement
import robotran.scene3d.model.SceneElementKind
import robotran.scene3d.model.SceneNode
import robotran.scene3d.model.Things
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.centre

/**
 * A flag on the paper.
 *
 * @property met whether its goal is reached.
 */
data class FlagPlace(val place: Point, val met: Boolean)

/** What stands on the paper and hangs above it at one moment. */
class Scene internal constructor(internal val root: SceneNode.Stack, internal val shades: List<Shade>) {
    internal class Shade(val footprint: ConvexPolygon, val bottom: Double, val top: Double)
}

/**
 * Builds the scenes of one world. Everything that does not change is built once; belongs to one screen or picture.
 *
 * @param trigonometry any, because nothing of a run depends on it.
 */
class SceneBuilder(private val world: World, private val colours: SceneColours, trigonometry: Trigonometry) {
    private val round = Round(trigonometry)
    private val things = Things(world, colours, round)
    private val standing = things.standing()
    private val standingShades = standing.map { Scene.Shade(it.footprint, 0.0, Heights.WALL) }
    private val robots = world.robots.mapIndexed { number, robot -> RobotModel.of(number, robot, colours.robot, round) }
    private val lampRod = things.rod(0.0, Heights.STANDING, colours.lampShade)
    private val flagRod = things.rod(0.0, Heights.STANDING, colours.flag)
    private val lamps = world.lamps.map { lamp -> listOf(false, true).map { things.lamp(lamp, it) } }
    private val cloths = listOf(false, true).map(things::cloth)
    private val everywhere = ConvexPolygon.rectangle(-FAR, -FAR, FAR, FAR)

    /**
     * The scene in [state].
     *
     * @param flags the places of goals to be reached.
     * @param flagHeading the direction in which their cloths blow, in degrees; across the camera's for the best view.
     * @param eyeOf the robot through whose eye the scene is seen, of which only the bumpers are drawn; null for none.
     * @param faces of the robots in their order; those without one look straight out of their eyes.
     */
    fun scene(
        state: SessionState,
        flags: List<FlagPlace> = emptyList(),
        flagHeading: Double = 0.0,
        eyeOf: Int? = null,
        faces: List<RobotFace> = emptyList(),
    ): Scene {
        val low = ArrayList<SceneNode>(standing)
        val high = ArrayList<SceneNode>()
        val shades = ArrayList(standingShades)
        for ((number, moved) in state.blocks.withIndex()) addBlock(number, moved, low, shades)
        for ((robot, now) in robots.zip(state.robots)) {
            val columns = robot.columns(
                now.robot,
                faces.getOrElse(robot.number) { RobotFace.STILL },
                bumpersOnly = robot.number == eyeOf,
            )
            low += columns
            columns.mapTo(shades) { Scene.Shade(it.footprint, SHADE_BOTTOM, heightOf(it)) }
        }
        for ((number, lamp) in state.lamps.withIndex()) {
            val place = turned(lamp.place, world.lamps[number].direction)
            val element = SceneElement(SceneElementKind.LAMP, number)
            low += SceneNode.Solid(lampRod, place, element)
            lamps[number][if (lamp.on) 1 else 0].let { high += stacked(it, place, element) }
        }
        for ((number, flag) in flags.withIndex()) {
            val place = turned(flag.place, flagHeading)
            val element = SceneElement(SceneElementKind.FLAG, number)
            low += SceneNode.Solid(flagRod, place, element)
            cloths[if (flag.met) 1 else 0].mapTo(high) { SceneNode.Solid(it, place, element) }
        }
        val levels = listOf(SceneNode.Group(everywhere, low), SceneNode.Group(everywhere, high))
        return Scene(SceneNode.Stack(everywhere, levels, listOf(Heights.STANDING)), shades)
    }

    private fun addBlock(number: Int, moved: Pose, nodes: MutableList<SceneNode>, shades: MutableList<Scene.Shade>) {
        val centre = world.blocks[number].shape.centre
        val place = turned(Point(centre.x + moved.x, centre.y + moved.y), moved.heading)
        val element = SceneElement(SceneElementKind.BLOCK, number)
        for (body in things.blocks[number]) {
            val node = SceneNode.Solid(body, place, element)
            nodes += node
            shades += Scene.Shade(node.footprint, 0.0, Heights.BLOCK)
        }
    }

    private fun turned(point: Point, degrees: Double): Placement {
        val angle = degrees * RADIANS_PER_DEGREE
        return Placement(point.x, point.y, 0.0, round.cosine(angle), round.sine(angle))
    }

    /** The parts of a lamp on top of each other. */
    private fun stacked(bodies: List<Body>, placement: Placement, element: SceneElement): SceneNode {
        val nodes = bodies.map { SceneNode.Solid(it, placement, element) }
        return SceneNode.Stack(nodes.last().footprint, nodes, bodies.drop(1).map { it.bottom })
    }

    private fun heightOf(node: SceneNode): Double = when (node) {
        is SceneNode.Solid -> node.body.top
        is SceneNode.Group -> node.parts.maxOf { heightOf(it) }
        is SceneNode.Stack -> node.levels.maxOf { heightOf(it) }
    }

    private companion object {
        /** In centimetres: beyond any place of a world. */
        const val FAR = 10_000.0

        /** What is under a robot is in its shade, although there is air. */
        const val SHADE_BOTTOM = 0.0
    }
}
