package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.ObjectBuilder
import robotran.json.decimal
import robotran.json.jsonObject
import robotran.world.BumperPart
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart

/** [robot] in a world: its name if it is a ready one. */
internal fun elementOf(robot: RobotDescription): JsonElement =
    robot.base?.takeIf { ReadyRobots.all[it] == robot }?.let(::JsonPrimitive)
        ?: jsonObject(robot.unknown.members) { describe(robot) }

/** Only what differs from the robot that it is like. */
internal fun ObjectBuilder.describe(robot: RobotDescription) {
    val base = robot.base?.let { ReadyRobots.all[it] }
    val like = base ?: ReadyRobots.defaultOf(robot.brick)
    text("title", robot.title)
    text("like", base?.base)
    text("brick", brickWord(robot.brick), default = brickWord(base?.brick ?: ReadyRobots.RCX_PENBOT.brick))
    val chassis = robot.chassis
    if (chassis.outline != like.chassis.outline) put("outline", points(chassis.outline))
    number("height", chassis.height, default = like.chassis.height)
    number("mass", chassis.mass, default = like.chassis.mass)
    if (chassis.massAt != like.chassis.massAt) put("massAt", point(chassis.massAt))
    if (robot.drive != like.drive) put("wheels", elementOf(robot.drive, like.drive))
    if (robot.casters != like.casters) put("casters", points(robot.casters))
    if (robot.pen != like.pen) put("pen", robot.pen?.let { JsonPrimitive(it.motor.name) } ?: JsonNull)
    if (robot.brickAt.at != like.brickAt.at) put("brickAt", point(robot.brickAt.at))
    flag("brickTurned", robot.brickAt.turned, default = like.brickAt.turned)
    if (robot.buggy != like.buggy) robot.buggy?.let { put("buggy", elementOf(it)) }
    if (robot.parts != like.parts) put("parts", JsonArray(robot.parts.map(::elementOf)))
}

private fun elementOf(drive: Drive, like: Drive) = jsonObject {
    number("diameter", drive.wheelDiameter, default = like.wheelDiameter)
    number("width", drive.wheelWidth, default = like.wheelWidth)
    number("track", drive.track, default = like.track)
    number("gear", drive.gear, default = like.gear)
    text("left", drive.left.name, default = like.left.name)
    text("right", drive.right.name, default = like.right.name)
    flag("reversed", drive.reversed, default = like.reversed)
    number("grip", drive.tyreFriction, default = like.tyreFriction)
}

private fun elementOf(part: RobotPart): JsonObject = jsonObject(part.unknown.members) {
    when (part) {
        is BumperPart -> {
            head(PartKind.BUMPER, part)
            put("at", point(part.at))
            number("width", part.width)
            number("depth", part.depth, default = BumperPart.DEFAULT_DEPTH)
            number("direction", part.direction, default = 0.0)
            text("side", part.side?.let(::wordFor))
        }

        is FingerTouchPart -> head(PartKind.TOUCH, part)

        is RotationPart -> {
            head(PartKind.ROTATION, part)
            text("wheel", wordFor(part.wheel))
        }

        is SensorPart -> {
            head(PartKind.entries.first { it.sensor == part.sensor }, part)
            put("at", point(part.at))
            number("height", part.height, default = defaultHeight(part.facing))
            if (part.facing != defaultFacing(part.sensor)) put("facing", elementOf(part.facing))
            text("turret", part.turret?.name)
        }
    }
}

private fun ObjectBuilder.head(kind: PartKind, part: RobotPart) {
    text("kind", wordFor(kind))
    number("port", part.port)
}

private fun elementOf(facing: Facing): JsonElement = when (facing) {
    Facing.Down -> JsonPrimitive("down")
    Facing.Free -> JsonPrimitive("free")
    is Facing.Ahead -> decimal(facing.direction)
}
