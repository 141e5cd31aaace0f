package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.simulation.state.RobotState
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Penbot
import robotran.world.RobotPlacement
import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.robot.bumpers
import kotlin.math.abs

/**
 * Any robot as columns that stand side by side: the wheels, the chassis with all that is on it and below it, and what
 * is outside of it, bumpers and sensors. The chassis is the hull of its outline, between the tyres.
 */
internal class BuiltRobotModel(
    override val number: Int,
    private val build: RobotPlacement,
    private val palette: RobotPalette,
    private val round: Round,
) : RobotModel {
    private val robot = build.description
    private val element = SceneElement(SceneElementKind.ROBOT, number)
    private val ink = palette.ink(number)
    private val wheelShape = with(robot.drive) {
        WheelShape(wheelDiameter / 2, track / 2 - wheelWidth / 2, track / 2 + wheelWidth / 2)
    }
    private val moving = MovingBodies(palette, round, wheelShape)
    private val hull: ConvexPolygon = chassisHull()
    private val chassis = prism(hull, RobotPlan3D.CHASSIS_BOTTOM, RobotPlan3D.CHASSIS_TOP, palette.chassis)
    private val holder = robot.pen?.let { ChassisBodies.holder(palette, round) }
    private val tip = robot.pen?.let { moving.penTip(ink) }
    private val brick = BrickOnRobot(robot, build, palette, round, wheelShape)
    private val sensors = SensorSeats(robot, hull, brick.box, palette, round).all
    private val casters = robot.casters.mapNotNull(::caster)
    private val bumpers = robot.bumpers
    private val bars = bumpers.map { bumper -> listOf(0.0, TRAVEL).map { bar(bumper, it) } }

    override fun columns(state: RobotState, face: RobotFace, bumpersOnly: Boolean): List<SceneNode> {
        val heading = state.pose.heading * RADIANS_PER_DEGREE
        val place = Placement(state.pose.x, state.pose.y, 0.0, round.cosine(heading), round.sine(heading))
        val bumperNodes = bars.mapIndexed { index, (free, pressed) ->
            solid(if (isPressed(index, state)) pressed else free, place)
        }
        if (bumpersOnly) return bumperNodes
        val wheels = listOf(true to state.leftWheelTurn, false to state.rightWheelTurn).map { (left, turn) ->
            solid(moving.wheel(left, turn), place)
        }
        return wheels + body(place, face, state) + bumperNodes + sensorsOn(SensorLevel.OUTSIDE, place, state)
    }

    private fun body(placement: Placement, face: RobotFace, state: RobotState): SceneNode {
        val footprint = hull.placed(placement.x, placement.y, placement.cosine, placement.sine)
        val lift = (1 - state.penDepth / Penbot.PEN_CONTACT).coerceAtLeast(0.0) * RobotPlan3D.PEN_LIFT
        val low = casters.map { solid(it, placement) } + sensorsOn(SensorLevel.BELOW_CHASSIS, placement, state) +
            listOfNotNull(tip?.let { solid(it, placement.raised(lift)) })
        val pen = holder?.let {
            val stand = solid(it, placement)
            SceneNode.Stack(
                stand.footprint,
                listOf(stand, solid(moving.penBarrel(ink, lift), placement)),
                listOf(RobotPlan3D.HOLDER_TOP),
            )
        }
        val high =
            brick.motors.map { solid(it, placement) } + listOfNotNull(pen) + brickColumn(placement, face, state) +
                sensorsOn(SensorLevel.ON_CHASSIS, placement, state)
        return SceneNode.Stack(
            footprint,
            listOf(SceneNode.Group(footprint, low), solid(chassis, placement), SceneNode.Group(footprint, high)),
            listOf(RobotPlan3D.CHASSIS_BOTTOM, RobotPlan3D.CHASSIS_TOP),
        )
    }

    private fun brickColumn(placement: Placement, face: RobotFace, state: RobotState): SceneNode {
        val solid = solid(brick.body, brick.placeOn(placement))
        val onTop =
            brick.eyes.of(face).map { solid(it, placement) } + sensorsOn(SensorLevel.ON_BRICK, placement, state) +
                listOfNotNull(brick.beacon?.let { solid(it, placement) })
        val levels = listOf(solid, SceneNode.Group(solid.footprint, onTop))
        return SceneNode.Stack(solid.footprint, levels, listOf(RobotPlan3D.BRICK_TOP))
    }

    private fun sensorsOn(level: SensorLevel, placement: Placement, state: RobotState): List<SceneNode> {
        val turn = state.turret * RADIANS_PER_DEGREE
        val turret = Placement(cosine = round.cosine(turn), sine = round.sine(turn))
        return sensors.filter { it.level == level }.map {
            solid(it.body, (if (it.isTurning) turret.on(it.place) else it.place).on(placement))
        }
    }

    /** A caster, behind a sensor that is in its place. */
    private fun caster(at: Point): Body? {
        val low = sensors.filter { it.level == SensorLevel.BELOW_CHASSIS }.map { it.place }
        val reach = SensorBodies.LOW_HALF + CASTER_RADIUS
        val inTheWay = low.filter { abs(it.x - at.x) < reach && abs(it.y - at.y) < reach }
        val x = inTheWay.minOfOrNull { it.x - reach - GAP } ?: at.x
        val covered = Box(x - CASTER_RADIUS, at.y - CASTER_RADIUS, x + CASTER_RADIUS, at.y + CASTER_RADIUS)
        val isFree = covered.isIn(hull) && low.none { abs(it.x - x) < reach && abs(it.y - at.y) < reach } &&
            covered.isApartFrom(PEN_TIP)
        if (!isFree) return null
        val circle = round.circle(x, at.y, CASTER_RADIUS, CASTER_CORNERS)
        return prism(circle, 0.0, RobotPlan3D.CHASSIS_BOTTOM, palette.clip, smooth = true)
    }

    /** The bar of a bumper that is moved in by [way]; it begins outside of the chassis. */
    private fun bar(bumper: BumperPart, way: Double): Body {
        val angle = bumper.direction * RADIANS_PER_DEGREE
        val (x, y) = round.cosine(angle) to round.sine(angle)
        val edge = hull.corners.maxOf { it.x * x + it.y * y }
        val room = (bumper.at.x * x + bumper.at.y * y - edge).coerceAtLeast(THINNEST)
        val depth = minOf(BAR_DEPTH, room)
        val moved = minOf(way, room - depth)

        fun corner(outwards: Double, leftwards: Double) = Point(
            bumper.at.x + (outwards - moved) * x - leftwards * y,
            bumper.at.y + (outwards - moved) * y + leftwards * x,
        )
        val half = bumper.width / 2
        val corners = listOf(corner(-depth, -half), corner(0.0, -half), corner(0.0, half), corner(-depth, half))
        return prism(
            ConvexPolygon(corners),
            RobotPlan3D.BUMPER_BOTTOM,
            RobotPlan3D.BUMPER_TOP,
            palette.bumper,
            shaded(palette.bumper, BAR_TOP),
        )
    }

    private fun isPressed(index: Int, state: RobotState): Boolean = index in state.pressed ||
        when (bumpers[index].side) {
            BumperSide.LEFT -> state.leftBumperPressed
            BumperSide.RIGHT -> state.rightBumperPressed
            null -> false
        }

    /** The hull of the outline, as far as it is between the tyres. */
    private fun chassisHull(): ConvexPolygon {
        val most = wheelShape.inner - GAP
        val corners = robot.chassis.outline.map { Point(it.x, it.y.coerceIn(-most, most)) }
        return ConvexPolygon.around(corners) ?: ConvexPolygon.rectangle(-most, -most, most, most)
    }

    private fun solid(body: Body, placement: Placement) = SceneNode.Solid(body, placement, element)

    private companion object {
        const val GAP = 0.05
        const val CASTER_RADIUS = 0.8
        const val CASTER_CORNERS = 10

        val PEN_TIP = Box(-0.7, -0.7, 0.7, 0.7)
        const val BAR_DEPTH = 0.8
        const val THINNEST = 0.2
        const val TRAVEL = 0.55
        const val BAR_TOP = 1.08
    }
}
