package robotran.world.file

import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class WriteWorldTest {
    @Test
    fun `everything that a file can hold is written so that people can read and merge it`() {
        assertEquals(WRITTEN, writeWorld(loaded(FULL_WORLD)))
    }

    @Test
    fun `what is written is read as the same world`() {
        (BuiltInWorlds.texts.values + FULL_WORLD).map(::loaded).forEach { assertEquals(it, loaded(writeWorld(it))) }
    }

    @Test
    fun `unknown fields are kept wherever they are`() {
        val text = FULL_WORLD
            .replace("\"title\"", "\"author\": {\"name\": \"Ms Frizzle\", \"born\": 1.50e3}, \"title\"")
            .replace("\"width\": 200", "\"width\": 200, \"squared\": true")
            .replace("\"heading\": 270", "\"heading\": 270, \"jitter\": 0.5")
            .replace("\"colour\": \"blue\"", "\"colour\": \"blue\", \"hat\": null")
            .replace("\"angle\": 30", "\"angle\": 30, \"round\": [1, [2]]")
            .replace("\"closed\": true", "\"closed\": true, \"dash\": \"\\ud800\"")
            .replace("\"radius\": 4 }", "\"radius\": 4, \"soft\": false }, \"points\": 5")
            .replace("\"strokes\"", "\"font\": \"Sans\", \"strokes\"")
        val world = loaded(text)
        val written = writeWorld(world)
        assertEquals(world, loaded(written))
        val kept = listOf(
            "\"author\": { \"name\": \"Ms Frizzle\", \"born\": 1.50e3 }",
            "\"squared\": true",
            "\"jitter\": 0.5",
            "\"hat\": null",
            "\"round\": [1, [2]]",
            "\"dash\": \"\\ud800\"",
            "\"soft\": false",
            "\"points\": 5",
            "\"font\": \"Sans\"",
        )
        kept.forEach { assertTrue(it in written, "$it is in\n$written") }
    }

    @Test
    fun `what version 1 did not know is kept too`() {
        val text = """{"format": "robotran-world", "version": 1, "name": "Old", "paper": {"width": 50, "height": 50, "a": 1}, "b": [2], "seed": 3,
            "walls": [{"from": {"x": 1, "y": 2, "c": 3}, "to": {"x": 3, "y": 2}, "thickness": 1, "d": 4}],
            "start": {"x": 20, "y": 20, "heading": 0, "e": 5}}"""
        val written = writeWorld(loaded(text))
        assertEquals(loaded(text), loaded(written))
        assertEquals(
            """
            {
              "format": "robotran-world",
              "version": 2,
              "title": "Old",
              "paper": { "width": 50, "height": 50, "a": 1 },
              "robots": [
                { "start": { "x": 20, "y": 20, "heading": 0, "e": 5 } }
              ],
              "walls": [
                { "from": [1, 2], "to": [3, 2], "thickness": 1, "d": 4, "from.c": 3 }
              ],
              "seed": 3,
              "b": [2]
            }

            """.trimIndent(),
            written,
        )
    }

    @Test
    fun `numbers are rounded to fifteen digits at most`() {
        val world = BuiltInWorlds.plain.copy(ambientLight = 1.0 / 3, temperature = 0.1 + 0.2)
        val written = writeWorld(world)
        assertTrue("\"light\": 0.333333333333333,\n  \"temperature\": 0.3" in written, written)
        assertEquals(written, writeWorld(loaded(written)))
    }

    @Test
    fun `a program with any line ends is written line by line`() {
        val robot = BuiltInWorlds.plain.robots.single().copy(program = "beep\r\n\r\nbuzz\n")
        val world: World = loaded(writeWorld(BuiltInWorlds.plain.copy(robots = listOf(robot))))
        assertEquals("beep\n\nbuzz\n", world.robots.single().program)
    }

    private companion object {
        val WRITTEN = """
            {
              "format": "robotran-world",
              "version": 2,
              "title": "Everything",
              "task": "Try all of it.",
              "paper": { "width": 200, "height": 100 },
              "robots": [
                {
                  "name": "ann",
                  "colour": "blue",
                  "start": { "x": 40, "y": 30, "heading": -90 },
                  "ports": { "1": "left bumper", "2": ["light", "touch"] },
                  "lightSensor": "forward",
                  "beacon": 0.5,
                  "program": [
                    "repeat forever",
                    "\tforward 5",
                    "end"
                  ]
                },
                { "name": "bob", "colour": "red", "start": { "x": 80, "y": 30, "heading": 0 } },
                { "name": "carl", "start": { "x": 120, "y": 30, "heading": 0 }, "robot": "line-follower" },
                {
                  "name": "dora",
                  "start": { "x": 180, "y": 50, "heading": 0 },
                  "robot": {
                    "title": "Sees all",
                    "like": "sumo",
                    "outline": [[-9, -5], [8, -5], [10, 0], [8, 5], [-9, 5]],
                    "height": 11,
                    "mass": 1.1,
                    "massAt": [0.6, 0],
                    "wheels": {
                      "diameter": 4.32,
                      "width": 2.2,
                      "track": 15,
                      "gear": 1.667,
                      "left": "B",
                      "right": "A",
                      "reversed": true,
                      "grip": 0.9
                    },
                    "casters": [[7, 2], [7, -2]],
                    "brickAt": [-1, 0],
                    "brickTurned": true,
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
              "walls": [
                { "from": [0, 90], "to": [120, 90], "thickness": 1.5 }
              ],
              "barriers": [
                { "name": "box", "rectangle": { "x": 10, "y": 60, "width": 5, "height": 4, "angle": 30 } },
                { "circle": { "x": 20, "y": 80, "radius": 3 } },
                { "polygon": [[100, 60], [110, 60], [105, 70]] }
              ],
              "blocks": [
                { "name": "brick", "circle": { "x": 150, "y": 20, "radius": 3 }, "mass": 0.2, "friction": 0.5 }
              ],
              "marks": [
                { "name": "loop", "grey": 0.1, "line": { "points": [[10, 10], [30, 10], [30, 50]], "width": 2, "closed": true } },
                { "colour": "#1133aa", "rectangle": { "x": 150, "y": 50, "width": 10, "height": 10 } },
                {
                  "greyMap": {
                    "x": 1,
                    "y": 1,
                    "cell": 1,
                    "rows": [
                      "0f.",
                      ".8f"
                    ]
                  }
                }
              ],
              "lamps": [
                { "name": "window", "x": 1, "y": 2, "brightness": 2, "direction": 90, "cone": 60, "on": false, "infrared": true }
              ],
              "light": 0.5,
              "temperature": 25,
              "template": { "strokes": [[[0, 0], [10, 0]], [[0, 5], [10, 5], [12, 7]]] },
              "goals": [
                {
                  "kind": "reach",
                  "region": { "circle": { "x": 5, "y": 5, "radius": 4 } },
                  "who": "brick",
                  "whole": true,
                  "within": 30,
                  "stays": true
                },
                { "kind": "stayOut", "region": { "polygon": [[0, 0], [1, 0], [1, 1]] }, "who": "ann", "whole": true },
                {
                  "kind": "stayIn",
                  "region": { "rectangle": { "x": 0, "y": 0, "width": 9, "height": 9 } },
                  "says": "Stay at home."
                },
                { "kind": "neverTouch", "what": ["walls", "robots"], "who": "bob" },
                { "kind": "drawTemplate", "tolerance": 2, "coverage": 0.8, "excess": 0.3 },
                {
                  "kind": "inOrder",
                  "goals": [
                    { "kind": "inkLength", "atLeast": 10, "atMost": 20 },
                    { "kind": "followLine", "line": "loop", "laps": 2.5, "tolerance": 3, "who": "ann", "within": 50 }
                  ]
                },
                {
                  "kind": "all",
                  "goals": [
                    { "kind": "endWithin", "seconds": 20, "who": "ann" }
                  ]
                },
                {
                  "kind": "anyOf",
                  "goals": [
                    { "kind": "showOnDisplay", "text": "HELLO", "who": "bob" },
                    { "kind": "playSound", "times": 3, "lowest": 400, "highest": 500, "who": "bob" }
                  ]
                }
              ],
              "timeLimit": 90,
              "realism": 0.3,
              "seed": 7
            }

        """.trimIndent()
    }
}
