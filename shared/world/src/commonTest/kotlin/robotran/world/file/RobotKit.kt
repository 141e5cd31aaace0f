package robotran.world.file

import robotran.language.Language
import robotran.world.RobotDescription
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** A robot of an NXT with every feature of the file format. */
internal val FULL_ROBOT = """
    {
      "format": "robotran-robot",
      "version": 1,
      "title": "Sees all",
      "like": "sumo",
      "brick": "nxt",
      "outline": [[-9, -5], [8, -5], [10, 0], [8, 5], [-9, 5]],
      "height": 11,
      "mass": 1.1,
      "massAt": [0.6, 0],
      "wheels": {
        "diameter": 4.32, "width": 2.2, "track": 15, "gear": 1.667, "left": "B", "right": "A", "reversed": true, "grip": 0.9
      },
      "casters": [[7, 2], [7, -2]],
      "pen": null,
      "brickAt": [-1, 0],
      "brickTurned": true,
      "parts": [
        { "kind": "bumper", "port": 1, "at": [-9.5, 1], "width": 9, "depth": 1.5, "direction": 180, "side": "left" },
        { "kind": "ultrasonic", "port": 4, "at": [9, 0], "height": 12, "facing": 45, "turret": "C" },
        { "kind": "light", "port": 3, "at": [8.5, 1], "height": 2, "facing": "down" },
        { "kind": "rotation", "wheel": "right" },
        { "kind": "touch" }
      ],
      "buggy": {
        "kind": "plain", "trim": [1, 0.98],
        "pins": {
          "drive": "bridge", "left": [12, 8], "right": [16, 14], "lines": [0, 1], "darkIsOne": false, "trigger": 15, "echo": 13, "pen": 2
        }
      }
    }
""".trimIndent()

internal fun loadedRobot(text: String): RobotDescription = when (val result = readRobot(text, Language.ENGLISH)) {
    is RobotFileResult.Success -> result.robot
    is RobotFileResult.Failure -> throw AssertionError(result.message)
}

/** The error message for the full robot with [new] instead of the first [old]. */
internal fun robotFileError(old: String, new: String): String {
    assertTrue(old in FULL_ROBOT, "$old is in the file")
    return assertIs<RobotFileResult.Failure>(readRobot(FULL_ROBOT.replaceFirst(old, new), Language.ENGLISH)).message
}

/** Checks what holds for every result: a robot is restored after writing, a rejection has a sentence and a place. */
internal fun holds(result: RobotFileResult) {
    when (result) {
        is RobotFileResult.Success -> {
            val again = assertIs<RobotFileResult.Success>(readRobot(writeRobot(result.robot), Language.ENGLISH))
            assertEquals(result.robot, again.robot)
        }

        is RobotFileResult.Failure -> {
            assertTrue(result.message.endsWith("."), result.message)
            assertTrue(result.path.isEmpty() || result.line != null, result.message)
            assertTrue(result.line == null || result.message.startsWith("Line ${result.line}"), result.message)
        }
    }
}
