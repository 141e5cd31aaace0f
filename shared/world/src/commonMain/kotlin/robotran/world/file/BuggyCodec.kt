package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonPrimitive
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.json.JsonCursor
import robotran.json.decimal
import robotran.json.jsonObject
import robotran.world.BuggyMount
import robotran.world.messages.robotReason
import robotran.world.roundToThousandths

private val KINDS = BuggyKind.entries.associateBy { it.word }
private val DRIVES = PlainDrive.entries.associateBy { wordFor(it) }
private val PINS = BuggyPins.USABLE.first()..BuggyPins.USABLE.last()

/**
 * A buggy.
 *
 * @param isKept whether the robot has one; otherwise nothing of it is written again, not even fields that nobody knows.
 */
internal fun readBuggy(cursor: JsonCursor, isKept: Boolean): BuggyMount? {
    val buggy = BuggyMount(
        kind = cursor.member("kind").choice(KINDS),
        trim = cursor.optional("trim")?.let(::readTrim) ?: WheelTrim.NONE,
        pins = cursor.optional("pins")?.let(::readPins),
    )
    if (!isKept) cursor.rest()
    return buggy.takeIf { isKept }
}

/** See [readBuggy]. */
internal fun elementOf(buggy: BuggyMount): JsonElement = jsonObject {
    text("kind", buggy.kind.word)
    if (buggy.trim != WheelTrim.NONE) {
        put("trim", JsonArray(listOf(decimal(buggy.trim.left), decimal(buggy.trim.right))))
    }
    buggy.pins?.let { put("pins", elementOf(it)) }
}

private fun elementOf(pins: BuggyPins) = jsonObject {
    text("drive", wordFor(pins.drive))
    put("left", numbers(pins.left))
    put("right", numbers(pins.right))
    if (pins.lines.isNotEmpty()) put("lines", numbers(pins.lines))
    flag("darkIsOne", pins.isDarkOne, default = true)
    number("trigger", pins.trigger)
    number("echo", pins.echo)
    number("pen", pins.pen)
}

private fun numbers(pins: List<Int>) = JsonArray(pins.map(::JsonPrimitive))

private fun readTrim(cursor: JsonCursor): WheelTrim {
    val (left, right) = cursor.items(2..2).map { roundToThousandths(it.number(BuggyMount.TRIMS)) }
    return WheelTrim(left, right)
}

private fun readPins(cursor: JsonCursor): BuggyPins {
    val usual = BuggyPins.of(cursor.member("drive").choice(DRIVES))
    val drive = usual.drive
    val wheel = drive.pinsOfWheel..drive.pinsOfWheel
    val pins = BuggyPins(
        drive,
        left = cursor.optional("left")?.items(wheel)?.map(::readPin) ?: usual.left,
        right = cursor.optional("right")?.items(wheel)?.map(::readPin) ?: usual.right,
        lines = cursor.optional("lines")?.items(0..BuggyPins.MOST_LINES)?.map(::readPin).orEmpty(),
        isDarkOne = cursor.optional("darkIsOne")?.flag() ?: true,
        trigger = cursor.optional("trigger")?.let(::readPin),
        echo = cursor.optional("echo")?.let(::readPin),
        pen = cursor.optional("pen")?.let(::readPin),
    )
    pins.all.groupBy { it }.values.firstOrNull { it.size > 1 }?.let { taken ->
        cursor.refuseInSentence(robotReason { pinTaken(taken.first()) })
    }
    return pins
}

private fun readPin(cursor: JsonCursor): Int {
    val pin = cursor.wholeNumber(PINS)
    return pin.takeIf { it in BuggyPins.USABLE } ?: cursor.refuseInSentence(
        robotReason { pinOfBoard(pin, BuggyPins.USABLE.map { "$it" }) },
    )
}
