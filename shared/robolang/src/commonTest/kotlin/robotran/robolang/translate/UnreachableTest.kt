package robotran.robolang.translate

import kotlin.test.Test
import kotlin.test.assertEquals

/** Java rejects unreachable statements; Robolang only warns about them. */
class UnreachableTest {
    @Test
    fun `behind an endless loop everything is a comment`() = assertJava(
        "repeat forever\n  beep\nend\nbuzz // never",
        "while (true) {",
        "Sound.beep();",
        "}",
        NEVER,
        "// Sound.buzz(); // never",
        "}",
    )

    @Test
    fun `behind a break the rest of the round is a comment, blocks and their comments included`() = assertJava(
        "repeat forever\n  break\n  // on and on\n  repeat 2 times\n    beep\n  end\nend\nbuzz",
        "while (true) {",
        "break;",
        NEVER,
        "// on and on",
        "// for (int lap = 0; lap < 2; lap++) {",
        "// Sound.beep();",
        "// }",
        "}",
        "Sound.buzz();",
        "}",
    )

    @Test
    fun `a break that is reached lets the program go on`() = assertJava(
        "repeat forever\n  if light < 40\n    break\n  end\nend\nbuzz",
        "while (true) {",
        "if (Sensor.S2.readValue() < 40) {",
        "break;",
        "}",
        "}",
        "Sound.buzz();",
        "}",
    )

    @Test
    fun `behind a choice of which every way leaves, nothing is reached`() = assertJava(
        "procedure p()\n  if light < 40\n    return\n  else\n    repeat while true\n      beep\n    end\n  end\n  " +
            "buzz\nend\np()",
        "if (Sensor.S2.readValue() < 40) {",
        "return;",
        "} else {",
        "while (true) {",
        "Sound.beep();",
        "}",
        "}",
        NEVER,
        "// Sound.buzz();",
        "}",
    )

    @Test
    fun `Java does not know that nothing comes behind a halt`() =
        assertJava("halt\nbeep", "System.exit(0);", "Sound.beep();", "}")

    @Test
    fun `a condition that Java can work out does not hide what follows`() = assertJava(
        "repeat until 1 == 2\n  beep\nend\nbuzz",
        "while (true) {",
        "if (1 == 2) break;",
        "Sound.beep();",
        "}",
        "Sound.buzz();",
        "}",
    )

    private fun assertJava(source: String, vararg expected: String) {
        val java = javaLinesOf(source).filter { it.isNotEmpty() }
        val place = java.indexOf(expected.first())
        assertEquals(
            expected.toList(),
            java.subList(place.coerceAtLeast(0), (place + expected.size).coerceAtMost(java.size)),
        )
    }

    private companion object {
        const val NEVER = "// The program never gets to the lines below."
    }
}
