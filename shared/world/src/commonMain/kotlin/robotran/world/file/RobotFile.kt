package robotran.world.file

import robotran.json.JsonCursor
import robotran.json.JsonFormat
import robotran.json.JsonReading
import robotran.json.JsonWarning
import robotran.json.jsonObject
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.world.RobotDescription
import robotran.world.messages.robotReason

/** The result of reading a robot file. */
sealed interface RobotFileResult {
    /** @property warnings about fields that are probably misspelt. */
    data class Success(val robot: RobotDescription, val warnings: List<JsonWarning> = emptyList()) : RobotFileResult

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the value with the error, such as `parts[2]`; empty if none.
     */
    data class Failure(val message: String, val line: Int?, val path: String) : RobotFileResult
}

/**
 * Reads a robot file, whose name ends in `.robot.json`; `docs/robots.md` describes the format. Returns quickly for any
 * text: it reads the file or rejects it. Unknown fields are preserved in the robot's
 * [robotran.world.UnknownFields].
 *
 * @param language the language of error messages.
 */
fun readRobot(text: String, language: Language): RobotFileResult = resultOf(readJson(text, language, ::robotIn))

/** The same for the bytes of a file, in any encoding that [robotran.language.decodeText] knows. */
fun readRobot(bytes: ByteArray, language: Language): RobotFileResult = resultOf(readJson(bytes, language, ::robotIn))

/**
 * [robot] as a file, with what differs from the ready robot that it is like. [readRobot] restores the same robot if its
 * figures have at most three decimals, or are those of that ready robot.
 */
fun writeRobot(robot: RobotDescription): String = writeJson(
    jsonObject(robot.unknown.members) {
        text("format", ROBOT_FORMAT)
        number("version", ROBOT_VERSION)
        describe(robot)
    },
)

private fun robotIn(cursor: JsonCursor): RobotDescription {
    FORMAT.versionOf(cursor)
    return readDescription(cursor)
}

private fun resultOf(reading: JsonReading<RobotDescription>): RobotFileResult = when (reading) {
    is JsonReading.Success -> RobotFileResult.Success(reading.value, reading.warnings)
    is JsonReading.Failure -> RobotFileResult.Failure(reading.message, reading.line, reading.path)
}

private const val ROBOT_FORMAT = "robotran-robot"
private const val ROBOT_VERSION = 1
private val FORMAT = JsonFormat(
    ROBOT_FORMAT,
    ROBOT_VERSION,
    robotReason { notARobot(ROBOT_FORMAT) },
    { version -> robotReason { newerRobot(version, ROBOT_VERSION) } },
)
