package robotran.ui.sheet3d

import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import robotran.scene3d.FlagPlace
import robotran.scene3d.Scene
import robotran.scene3d.SceneBuilder
import robotran.scene3d.camera.Projection
import robotran.simulation.state.SessionState
import robotran.ui.sheet.GoalRegion
import robotran.ui.sheet.distance
import robotran.ui.sheet.goalRegions
import robotran.ui.sheet.penbotFace
import robotran.ui.sheet.roomiestPoint
import robotran.workshop.state.SheetLayer
import robotran.world.RegionRole
import robotran.world.World
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.atan2

/** Prepares a world for drawing in perspective. Belongs to one screen or picture and one thread. */
internal class SpaceDrawing(internal val world: World, internal val colours: SpaceColours) {
    internal val tiles = PaperTiles(world, colours.sheet)
    private val builder = SceneBuilder(world, colours.scene(world.robots), ScreenTrigonometry)
    internal val targets: List<Target> = goalRegions(world.goals).filter { it.role == RegionRole.TARGET }
        .map { Target(it, besideLamps(roomiestPoint(it.shape).first)) }

    /** The place of a goal to be reached. */
    internal class Target(val region: GoalRegion, val place: Point)

    /** A flag does not stand where a lamp does. */
    private fun besideLamps(point: Point): Point =
        if (world.lamps.none { distance(it.place, point) < LAMP_ROOM }) point else Point(point.x - LAMP_ROOM, point.y)

    /**
     * What stands in [state], for the camera of [projection]; [eyeOf] is the robot that looks, if it is one's eye.
     *
     * @param isStill whether the eyes of robots never move, as for less motion.
     */
    fun scene(
        state: SessionState,
        shown: Set<SheetLayer>,
        projection: Projection,
        eyeOf: Int?,
        isStill: Boolean = false,
    ): Scene {
        val flags = if (SheetLayer.GOALS in shown) {
            targets.map { FlagPlace(it.place, it.region.isMet(state.goals)) }
        } else {
            emptyList()
        }
        val faces = state.robots.indices.map {
            spaceFace(penbotFace(state, it, isStill, world.robots[it].description.drive))
        }
        return builder.scene(state, flags, across(projection), eyeOf, faces)
    }

    /** The direction to the right in the picture, in degrees. */
    private fun across(projection: Projection) = projection.view.right.let { atan2(it.y, it.x) * DEGREES_PER_RADIAN }

    private companion object {
        const val DEGREES_PER_RADIAN = 180 / PI

        /** In centimetres. */
        const val LAMP_ROOM = 7.0
    }
}

/**
 * Draws a world in perspective: the room, the paper with its ink, shadows, and all that stands.
 *
 * @param labels measures names and readings; null omits them.
 */
internal fun DrawScope.drawSpace(
    drawing: SpaceDrawing,
    scene: Scene,
    state: SessionState,
    projection: Projection,
    shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    labels: TextMeasurer? = null,
    onGround: DrawScope.() -> Unit = {},
) {
    drawRoom(drawing.colours, projection)
    drawPaperShadow(drawing.world.paper, drawing.colours, projection)
    drawing.tiles.draw(this, state, shown, projection)
    drawLampShadows(drawing.world, state, projection)
    if (SheetLayer.SENSORS in shown) drawSights3D(drawing.world, state, projection)
    drawShadows(scene, drawing.colours, projection)
    onGround()
    drawSolids3D(scene, drawing.colours, projection)
    if (labels != null) drawLabels3D(drawing, state, projection, shown, labels)
}
