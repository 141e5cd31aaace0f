package robotran.world.robot

import robotran.brick.sensors.SensorKind
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.PortSensor
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.pluggedSensors
import robotran.world.roundToThousandths
import robotran.world.withPlugged

/**
 * A part of this kind for [port], in its usual place on this robot: a bumper on the left for port 1, on the right for
 * the [BrickBuild.rightBumperPort], and otherwise all across; a light or colour sensor that looks down in
 * front, a sonar ahead.
 */
fun RobotDescription.partFor(kind: SensorKind, port: Int): RobotPart {
    val front = roundToThousandths(chassis.outline.maxOf { it.x })
    val height = roundToThousandths(chassis.height)
    return when (kind) {
        SensorKind.TOUCH -> bumperFor(port, front)
        SensorKind.ROTATION -> RotationPart(port, sideOf(port) ?: BumperSide.LEFT)
        SensorKind.LIGHT -> SensorPart(port, kind, Point(front, 0.0), DOWN_HEIGHT, Facing.Free)

        SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR, SensorKind.RCX_LIGHT -> {
            SensorPart(port, kind, Point(front, 0.0), DOWN_HEIGHT, Facing.Down)
        }

        SensorKind.ULTRASONIC, SensorKind.OPTICAL_DISTANCE, SensorKind.RCX_LINK, SensorKind.INFRARED_SEEKER,
        SensorKind.INFRARED_SEEKER_2,
        -> {
            SensorPart(port, kind, Point(front, 0.0), AHEAD_HEIGHT, Facing.Ahead(0.0))
        }

        SensorKind.TEMPERATURE, SensorKind.SOUND, SensorKind.COMPASS, SensorKind.GYRO, SensorKind.MINDSENSORS_COMPASS,
        SensorKind.HITECHNIC_ACCELERATION, SensorKind.MINDSENSORS_ACCELERATION, SensorKind.NXT_TEMPERATURE,
        -> {
            SensorPart(port, kind, Point(0.0, 0.0), height, Facing.Ahead(0.0))
        }
    }
}

/**
 * The same robot with a sensor of this kind on [port], instead of what is there: one that is on the robot, but plugged
 * in nowhere, or a new one. A penbot gets its own sensors, and both bumpers on port 2.
 */
fun RobotDescription.withSensor(kind: SensorKind, port: Int): RobotDescription {
    if (BrickBuild.of(brick).hasShortForm) {
        val wanted = pluggedSensors.mapIndexed { index, plugged ->
            if (index == port - 1) penbotSensors(kind, sideOf(port)) else plugged
        }
        if (wanted.getOrNull(port - 1)?.isNotEmpty() == true) return withPlugged(wanted)
    }
    val freed = parts.mapNotNull { part -> if (part.port == port) (part as? BumperPart)?.on(null) else part }
    val loose = freed.indexOfFirst { it.port == null && it.kind == kind }
    return copy(
        parts = if (loose >= 0) {
            freed.mapIndexed { number, part -> if (number == loose) part.on(port) else part }
        } else {
            freed + partFor(kind, port)
        },
    )
}

/** Empty for what no penbot has. */
private fun penbotSensors(kind: SensorKind, side: BumperSide?): List<PortSensor> = when (kind) {
    SensorKind.TOUCH -> {
        when (side) {
            BumperSide.LEFT -> listOf(PortSensor.LEFT_BUMPER)
            BumperSide.RIGHT -> listOf(PortSensor.RIGHT_BUMPER)
            null -> listOf(PortSensor.LEFT_BUMPER, PortSensor.RIGHT_BUMPER)
        }
    }

    SensorKind.TEMPERATURE -> listOf(PortSensor.TEMPERATURE)
    SensorKind.LIGHT -> listOf(PortSensor.LIGHT)

    SensorKind.ROTATION -> {
        listOf(if (side == BumperSide.RIGHT) PortSensor.RIGHT_ROTATION else PortSensor.LEFT_ROTATION)
    }

    else -> emptyList()
}

/** null for a port between. */
private fun RobotDescription.sideOf(port: Int): BumperSide? = when {
    port == 1 -> BumperSide.LEFT
    port == BrickBuild.of(brick).rightBumperPort -> BumperSide.RIGHT
    else -> null
}

private fun RobotDescription.bumperFor(port: Int, front: Double): BumperPart {
    val across = roundToThousandths(chassis.outline.across)
    val side = sideOf(port)
    val width = if (side == null) across else roundToThousandths((across - BUMPER_GAP) / 2)
    val middle = when (side) {
        BumperSide.LEFT -> roundToThousandths((width + BUMPER_GAP) / 2)
        BumperSide.RIGHT -> roundToThousandths(-(width + BUMPER_GAP) / 2)
        null -> 0.0
    }
    return BumperPart(port, Point(roundToThousandths(front + BumperPart.DEFAULT_DEPTH), middle), width, side = side)
}

private const val DOWN_HEIGHT = 1.0
private const val AHEAD_HEIGHT = 6.0
private const val BUMPER_GAP = 0.4
