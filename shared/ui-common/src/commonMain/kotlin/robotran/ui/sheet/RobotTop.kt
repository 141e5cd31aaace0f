package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.sensors.SensorCase
import robotran.brick.sensors.SensorKind
import robotran.simulation.state.RobotState
import robotran.uikit.*
import robotran.world.RobotPlacement

/** All of a robot but its wheels, eyes, pen and lamp. */
internal fun DrawTarget.drawBody(plan: RobotPlan, build: RobotPlacement, robot: RobotState) {
    plan.bumpers.forEachIndexed { index, bumper -> drawBumper(bumper, robot.isPressed(bumper.part, index)) }
    box(plan.axle, RobotColours.TREAD, 0.2f)
    if (plan.isBox) {
        box(plan.chassisBox, RobotColours.CHASSIS, 1f, RobotColours.CHASSIS_EDGE)
    } else {
        shape(plan.chassisOutline, RobotColours.CHASSIS, RobotColours.CHASSIS_EDGE, Line(EDGE_WIDTH))
    }
    for (motor in plan.motors) drawMotor(motor)
    with(plan.brick.look) { drawBrick(plan.brick, build.colour) }
    for (sensor in plan.sensors) {
        val degrees = sensor.degrees - robot.turn(sensor.part).toFloat()
        group(sensor.at, degrees) { drawSensor(sensor, plan.robot.brick.sensorCase) }
    }
}

private fun DrawTarget.drawBumper(bumper: BumperTop, isPressed: Boolean) {
    val way = if (isPressed) BumperTop.TRAVEL else 0f
    val draw: DrawTarget.() -> Unit = {
        box(bumper.armAt(way), RobotColours.BUMPER_EDGE, 0.1f)
        val colour = if (isPressed) RobotColours.BUMPER_EDGE else RobotColours.BUMPER
        box(bumper.barAt(way), colour, 0.6f, RobotColours.BUMPER_EDGE)
    }
    if (bumper.isAhead) draw() else group(bumper.at, bumper.degrees, content = draw)
}

private fun DrawTarget.drawMotor(motor: MotorTop) {
    if (motor.hub == null) {
        box(motor.body, RobotColours.MOTOR, 0.4f, RobotColours.CHASSIS_EDGE)
    } else {
        box(motor.body, RobotColours.NXT_GREY, 0.9f, RobotColours.CHASSIS_EDGE)
        disc(motor.hub, 0.95f, RobotColours.ORANGE, RobotColours.CHASSIS_EDGE)
    }
}

/** Around its place, looking ahead. */
private fun DrawTarget.drawSensor(sensor: SensorTop, case: SensorCase) {
    val body = sensor.body
    when (sensor.kind) {
        SensorKind.ULTRASONIC -> {
            box(body, RobotColours.NXT_GREY, 0.5f, RobotColours.CHASSIS_EDGE)
            for (y in listOf(-1.15f, 1.15f)) {
                disc(Offset(body.right - 0.85f, y), 0.8f, RobotColours.CHASSIS)
                disc(Offset(body.right - 0.85f, y), 0.42f, RobotColours.ORANGE)
            }
        }

        SensorKind.SOUND -> {
            box(body, RobotColours.NXT_GREY, 0.4f, RobotColours.CHASSIS_EDGE)
            disc(Offset(body.right - 0.8f, 0f), 0.75f, RobotColours.CHASSIS)
        }

        SensorKind.COLOUR -> {
            box(body, RobotColours.NXT_FACE, 0.3f, RobotColours.CHASSIS_EDGE)
            for ((x, part) in COLOUR_PARTS) disc(Offset(x, 0f), 0.26f, part)
        }

        SensorKind.HITECHNIC_COLOUR -> {
            box(body, RobotColours.CHASSIS, 0.3f, RobotColours.CHASSIS_EDGE)
            for (x in listOf(-0.4f, 0.4f)) disc(Offset(x, 0f), 0.3f, RobotColours.NXT_FACE)
        }

        SensorKind.MINDSENSORS_COMPASS, SensorKind.HITECHNIC_ACCELERATION, SensorKind.MINDSENSORS_ACCELERATION,
        SensorKind.RCX_LINK,
        -> {
            val isOfHitechnic = sensor.kind == SensorKind.HITECHNIC_ACCELERATION
            box(body, if (isOfHitechnic) RobotColours.CHASSIS else RobotColours.CLIP, 0.3f, RobotColours.CHASSIS_EDGE)
            box(Rect(-0.1f, -0.1f, 0.65f, 0.1f), RobotColours.NXT_FACE, 0.05f)
        }

        SensorKind.OPTICAL_DISTANCE -> {
            box(body, RobotColours.CHASSIS, 0.2f, RobotColours.CHASSIS_EDGE)
            for (y in listOf(-1.1f, 1.1f)) disc(Offset(body.right - 0.7f, y), 0.55f, RobotColours.NXT_FACE)
        }

        SensorKind.INFRARED_SEEKER, SensorKind.INFRARED_SEEKER_2 -> {
            disc(Offset.Zero, 1.2f, RobotColours.CHASSIS, RobotColours.CHASSIS_EDGE)
            for (y in listOf(-0.7f, 0f, 0.7f)) disc(Offset(0.5f, y), 0.22f, RobotColours.NXT_FACE)
        }

        SensorKind.RCX_LIGHT -> box(body, RobotColours.LIGHT_SENSOR, 0.3f, RobotColours.CHASSIS_EDGE)

        SensorKind.COMPASS, SensorKind.GYRO -> {
            box(body, RobotColours.CHASSIS, 0.3f, RobotColours.CHASSIS_EDGE)
            disc(Offset.Zero, 0.75f, RobotColours.NXT_FACE)
            box(Rect(-0.1f, -0.1f, 0.65f, 0.1f), RobotColours.PEN_TIP_DOWN, 0.05f)
        }

        else -> {
            when (case) {
                SensorCase.STUDDED -> box(body, RobotColours.LIGHT_SENSOR, 0.3f, RobotColours.CHASSIS_EDGE)

                SensorCase.ROUNDED -> {
                    box(body, RobotColours.NXT_GREY, 0.3f, RobotColours.CHASSIS_EDGE)
                    disc(Offset(0.2f, 0f), 0.32f, RobotColours.PEN_TIP_DOWN)
                }
            }
        }
    }
}

/** The places ahead of its middle and the colours of the lamps of a colour sensor. */
private val COLOUR_PARTS = listOf(
    -0.5f to RobotColours.PEN_TIP_DOWN,
    0f to RobotranColours.RUN_GREEN,
    0.5f to RobotColours.LIGHT_SENSOR,
)
