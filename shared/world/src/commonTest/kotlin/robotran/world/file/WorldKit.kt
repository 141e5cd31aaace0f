package robotran.world.file

import robotran.language.Language
import robotran.world.World
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** A world with every feature of the file format. */
internal val FULL_WORLD = """
    {
      "format": "robotran-world",
      "version": 2,
      "title": "Everything",
      "task": "Try all of it.",
      "paper": { "width": 200, "height": 100 },
      "robots": [
        {
          "name": "ann", "colour": "blue", "start": { "x": 40, "y": 30, "heading": 270 },
          "ports": { "1": "left bumper", "2": ["light", "touch"], "3": [] },
          "lightSensor": "forward", "beacon": 0.5, "program": ["repeat forever", "\tforward 5", "end"]
        },
        { "name": "bob", "colour": "red", "start": { "x": 80, "y": 30, "heading": 0 } },
        { "name": "carl", "start": { "x": 120, "y": 30, "heading": 0 }, "robot": "line-follower" },
        {
          "name": "dora", "start": { "x": 180, "y": 50, "heading": 0 },
          "robot": {
            "title": "Sees all", "like": "sumo", "brick": "nxt",
            "outline": [[-9, -5], [8, -5], [10, 0], [8, 5], [-9, 5]], "height": 11, "mass": 1.1, "massAt": [0.6, 0],
            "wheels": {
              "diameter": 4.32, "width": 2.2, "track": 15, "gear": 1.667, "left": "B", "right": "A", "reversed": true, "grip": 0.9
            },
            "casters": [[7, 2], [7, -2]], "pen": null, "brickAt": [-1, 0], "brickTurned": true, "buggy": { "kind": "plain", "trim": [1, 0.98], "pins": { "drive": "bridge", "left": [12, 8], "right": [16, 14], "lines": [0, 1], "darkIsOne": false, "trigger": 15, "echo": 13, "pen": 2 } },
            "parts": [
              { "kind": "bumper", "port": 1, "at": [-9.5, 1], "width": 9, "depth": 1.5, "direction": 180, "side": "left" },
              { "kind": "ultrasonic", "port": 4, "at": [9, 0], "height": 12, "facing": 45, "turret": "C" },
              { "kind": "light", "port": 3, "at": [8.5, 1], "height": 2, "facing": "down" },
              { "kind": "rotation", "wheel": "right" },
              { "kind": "touch" }
            ]
          }
        }
      ],
      "walls": [{ "from": [0, 90], "to": [120, 90], "thickness": 1.5 }],
      "barriers": [
        { "name": "box", "rectangle": { "x": 10, "y": 60, "width": 5, "height": 4, "angle": 30 } },
        { "circle": { "x": 20, "y": 80, "radius": 3 } },
        { "polygon": [[100, 60], [110, 60], [105, 70]] }
      ],
      "blocks": [{ "name": "brick", "circle": { "x": 150, "y": 20, "radius": 3 }, "mass": 0.2, "friction": 0.5 }],
      "marks": [
        { "name": "loop", "grey": 0.1, "line": { "points": [[10, 10], [30, 10], [30, 50]], "width": 2, "closed": true } },
        { "colour": "#1133AA", "rectangle": { "x": 150, "y": 50, "width": 10, "height": 10 } },
        { "greyMap": { "x": 1, "y": 1, "cell": 1, "rows": ["0F.", ".8f"] } }
      ],
      "lamps": [
        { "name": "window", "x": 1, "y": 2, "brightness": 2, "direction": 90, "cone": 60, "on": false, "infrared": true }
      ],
      "light": 0.5,
      "temperature": 25,
      "template": { "strokes": [[[0, 0], [10, 0]], [[0, 5], [10, 5], [12, 7]]] },
      "goals": [
        { "kind": "reach", "region": { "circle": { "x": 5, "y": 5, "radius": 4 } }, "who": "brick", "whole": true, "within": 30, "stays": true },
        { "kind": "stayOut", "region": { "polygon": [[0, 0], [1, 0], [1, 1]] }, "who": "ann", "whole": true },
        { "kind": "stayIn", "region": { "rectangle": { "x": 0, "y": 0, "width": 9, "height": 9 } }, "says": "Stay at home." },
        { "kind": "neverTouch", "what": ["walls", "robots"], "who": "bob" },
        { "kind": "drawTemplate", "tolerance": 2, "coverage": 0.8, "excess": 0.3 },
        { "kind": "inOrder", "goals": [
          { "kind": "inkLength", "atLeast": 10, "atMost": 20 },
          { "kind": "followLine", "line": "loop", "laps": 2.5, "tolerance": 3, "who": "ann", "within": 50 }
        ] },
        { "kind": "all", "goals": [{ "kind": "endWithin", "seconds": 20, "who": "ann" }] },
        { "kind": "anyOf", "goals": [
          { "kind": "showOnDisplay", "text": "HELLO", "who": "bob" },
          { "kind": "playSound", "times": 3, "lowest": 400, "highest": 500, "who": "bob" }
        ] }
      ],
      "timeLimit": 90,
      "realism": 0.3,
      "seed": 7
    }
""".trimIndent()

internal fun loaded(text: String): World = when (val result = readWorld(text, Language.ENGLISH)) {
    is WorldFileResult.Success -> result.world
    is WorldFileResult.Failure -> throw AssertionError(result.message)
}

internal fun refusal(text: String): WorldFileResult.Failure =
    assertIs<WorldFileResult.Failure>(readWorld(text, Language.ENGLISH))

/** The error message for the full world with [new] instead of the first [old]. */
internal fun refusalWith(old: String, new: String): String {
    assertTrue(old in FULL_WORLD, "$old is in the file")
    return refusal(FULL_WORLD.replaceFirst(old, new)).message
}

/** The error message after the line number; checks that the line is [line], by default that of [old]. */
internal fun complaint(
    old: String,
    new: String,
    line: Int = FULL_WORLD.substringBefore(old).count { it == '\n' } + 1,
): String {
    val message = refusalWith(old, new)
    assertTrue(message.startsWith("Line $line: "), "$message is about line $line")
    return message.substringAfter(": ")
}

/**
 * Checks the invariants of every result: a world is restored after writing, a rejection has a sentence and a matching
 * location.
 */
internal fun holds(result: WorldFileResult) {
    when (result) {
        is WorldFileResult.Success -> assertEquals(result.world, loaded(writeWorld(result.world)))

        is WorldFileResult.Failure -> {
            assertTrue(result.message.endsWith("."), result.message)
            assertTrue(result.path.isEmpty() || result.line != null, result.message)
            assertTrue(result.line == null || result.message.startsWith("Line ${result.line}"), result.message)
        }
    }
}
