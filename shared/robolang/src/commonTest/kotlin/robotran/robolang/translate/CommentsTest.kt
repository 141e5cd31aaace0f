package robotran.robolang.translate

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class CommentsTest {
    @Test
    fun `each comment of each program is in the Java once`() {
        val problems = programsForBoth.flatMap { (path, program) ->
            val wanted = program.checked.tree.comments.map {
                it.text.trimEnd().replace('\\', '/')
            }.groupingBy { it }.eachCount()
            var java = ownPart(translateRobolang(program).java)
            // Longest first, so that no comment is found inside another.
            wanted.entries.sortedByDescending { it.key.length }.mapNotNull { (comment, count) ->
                val found = java.split(comment).size - 1
                java = java.replace(comment, "")
                "$path: $comment is there $found times, not $count".takeIf { found != count }
            }
        }
        assertEquals(emptyList(), problems)
    }

    /** The Java of the program itself, without the translator's own comments. */
    private fun ownPart(java: String): String = java.substringAfter(
        '\n',
    ).substringBefore(METHODS_BELOW).replace("// The program never gets to the lines below.", "")

    @Test
    fun `a comment stays beside or above its line`() {
        val java = javaLinesOf("// draws\n\n// first this\nbeep // loud\nbuzz\n// the end")
        val place = java.indexOf("// first this")
        assertEquals(
            listOf("// first this", "Sound.beep(); // loud", "Sound.buzz();", "// the end"),
            java.subList(
                place,
                place + 4,
            ),
        )
        assertEquals("public class Test {", java[java.indexOf("// draws") + 1])
    }

    @Test
    fun `the comments of a header are above the sensors`() {
        val header =
            "// my robot\nrobot\n  // it looks at the line\n  light sensor on 2 facing down // near\nend // of the " +
                "header\n"
        val java = javaLinesOf(header + "show light")
        val place = java.indexOf("// my robot")
        assertEquals(
            listOf("// my robot", "// it looks at the line", "Sensor.S2.activate(); // near", "// of the header"),
            java.subList(place, place + 4),
        )
    }

    @Test
    fun `a comment cannot smuggle in Java`() {
        val java = translationOf("beep // \\u000A System.exit(0); */").java
        assertContains(java, "Sound.beep(); // /u000A System.exit(0); */")
    }

    @Test
    fun `blank lines stay, one at most and none at the edges of a block`() {
        val java = javaLinesOf("beep\n\n\nbuzz\nrepeat 2 times\n\n  beep\n\nend")
        val place = java.indexOf("Sound.beep();")
        val expected =
            listOf(
                "Sound.beep();",
                "",
                "Sound.buzz();",
                "for (int lap = 0; lap < 2; lap++) {",
                "Sound.beep();",
                "}",
                "}",
            )
        assertEquals(expected, java.subList(place, place + expected.size))
    }
}
