package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.simulation.state.RobotState
import robotran.world.LightFacing
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import robotran.world.geometry.RADIANS_PER_DEGREE

/**
 * A penbot as columns that stand side by side, so that it can be ordered among other things, and these between its
 * parts: a corner of a wall may be between wheel and bumper.
 */
internal class PenbotModel(
    override val number: Int,
    private val build: RobotPlacement,
    palette: RobotPalette,
    private val round: Round,
) : RobotModel {
    private val moving = MovingBodies(palette, round)
    private val element = SceneElement(SceneElementKind.ROBOT, number)
    private val ink = palette.ink(number)
    private val rear = ChassisBodies.rear(palette, round)
    private val motors = listOf(true, false).map { ChassisBodies.motor(it, palette) }
    private val holder = ChassisBodies.holder(palette, round)
    private val tip = moving.penTip(ink)
    private val front = ChassisBodies.front(palette, round)
    private val brick = brickBody(build.colour, palette, round)
    private val caster = ChassisBodies.caster(palette, round)
    private val sensor = if (build.ports.any { PortSensor.LIGHT in it }) {
        ChassisBodies.lightSensor(palette, build.lightFacing == LightFacing.FORWARD)
    } else {
        null
    }
    private val beacon = if (build.beacon > 0) beaconBody(palette, round) else null
    private val eyes = EyeBodies(palette.brick(build.colour), palette.brickEdge(build.colour), palette, round)
    private val bumpers = listOf(true, false).map { moving.bumper(it) to moving.bumperArm(it) }

    /** Where the robot stands in [state]. */
    private fun place(state: RobotState): Placement {
        val heading = state.pose.heading * RADIANS_PER_DEGREE
        return Placement(state.pose.x, state.pose.y, 0.0, round.cosine(heading), round.sine(heading))
    }

    override fun columns(state: RobotState, face: RobotFace, bumpersOnly: Boolean): List<SceneNode> {
        val place = place(state)
        val pressed = listOf(state.leftBumperPressed, state.rightBumperPressed)
        val sides = listOf(true, false)
        val bumperNodes = sides.map { left ->
            val index = if (left) 0 else 1
            val way = if (pressed[index]) -RobotPlan3D.BUMPER_TRAVEL else 0.0
            bumperColumn(place, left, bumpers[index], way)
        }
        if (bumpersOnly) return bumperNodes
        val turns = listOf(state.leftWheelTurn, state.rightWheelTurn)
        val wheels = sides.mapIndexed { index, left -> solid(moving.wheel(left, turns[index]), place) }
        return wheels + rearColumn(place, lifted(state)) + frontColumn(place, face) + bumperNodes
    }

    /** How high the pen is above the paper, in centimetres. */
    private fun lifted(state: RobotState): Double =
        (1 - state.penDepth / Penbot.PEN_CONTACT).coerceAtLeast(0.0) * RobotPlan3D.PEN_LIFT

    private fun rearColumn(placement: Placement, lift: Double): SceneNode {
        val footprint = around(placement, RobotPlan3D.REAR, RobotPlan3D.MIDDLE, RobotPlan3D.HALF_CHASSIS)
        val pen = SceneNode.Stack(
            solid(holder, placement).footprint,
            listOf(solid(holder, placement), solid(moving.penBarrel(ink, lift), placement)),
            listOf(RobotPlan3D.HOLDER_TOP),
        )
        val upper = SceneNode.Group(footprint, motors.map { solid(it, placement) } + pen)
        return SceneNode.Stack(
            footprint,
            listOf(solid(tip, placement.raised(lift)), solid(rear, placement), upper),
            listOf(RobotPlan3D.CHASSIS_BOTTOM, RobotPlan3D.CHASSIS_TOP),
        )
    }

    private fun frontColumn(placement: Placement, face: RobotFace): SceneNode {
        val footprint = around(placement, RobotPlan3D.MIDDLE, RobotPlan3D.FRONT, RobotPlan3D.HALF_BRICK)
        val below = SceneNode.Group(footprint, listOfNotNull(caster, sensor).map { solid(it, placement) })
        val above = SceneNode.Group(footprint, (eyes.of(face) + listOfNotNull(beacon)).map { solid(it, placement) })
        val levels = listOf(below, solid(front, placement), solid(brick, placement), above)
        val heights = listOf(RobotPlan3D.CHASSIS_BOTTOM, RobotPlan3D.CHASSIS_TOP, RobotPlan3D.BRICK_TOP)
        return SceneNode.Stack(footprint, levels, heights)
    }

    private fun bumperColumn(placement: Placement, left: Boolean, bodies: Pair<Body, Body>, way: Double): SceneNode {
        val from = if (left) RobotPlan3D.BUMPER_INNER else -RobotPlan3D.BUMPER_OUTER
        val footprint = ConvexPolygon.rectangle(
            RobotPlan3D.FRONT,
            from,
            RobotPlan3D.BUMPER_BACK + 0.8,
            from + RobotPlan3D.BUMPER_OUTER - RobotPlan3D.BUMPER_INNER,
        ).placed(placement.x, placement.y, placement.cosine, placement.sine)
        // A pressed bumper reaches over its arm, and hides it.
        val parts = if (way == 0.0) listOf(bodies.first, bodies.second) else listOf(bodies.first)
        return SceneNode.Group(footprint, parts.map { solid(it, placement.shifted(way)) })
    }

    private fun around(placement: Placement, from: Double, to: Double, half: Double) = ConvexPolygon.rectangle(
        from,
        -half,
        to,
        half,
    ).placed(placement.x, placement.y, placement.cosine, placement.sine)

    private fun solid(body: Body, placement: Placement) = SceneNode.Solid(body, placement, element)
}
