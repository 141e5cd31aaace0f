package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class LineMapTest {
    @Test
    fun `each line of each program has its lines of Java and they lead back to it`() {
        val problems = programsForBoth.flatMap { (path, program) ->
            val lineMap = translateRobolang(program).lineMap
            linesWithJava(program.checked.tree).mapNotNull { line ->
                val javaLines = lineMap.targetLinesOf(line)
                when {
                    javaLines.isEmpty() -> "$path:$line has no Java"
                    javaLines.any { lineMap.sourceLineOf(it) != line } -> "$path:$line is not where $javaLines lead"
                    else -> null
                }
            }
        }
        assertEquals(emptyList(), problems)
    }

    @Test
    fun `each line of Java that is not the same in many programs came from a line of the program`() {
        val problems = translatablePrograms.flatMap { (path, program) ->
            val translation = translateRobolang(program)
            val own = translation.java.lines().takeWhile { it.trim() != METHODS_BELOW }
            own.withIndex()
                .filter { (index, text) ->
                    translation.lineMap.sourceLineOf(index + 1) == null &&
                        !isCommon(text.trim())
                }
                .map { (index, text) -> "$path: line ${index + 1} of the Java came from nowhere: $text" }
        }
        assertEquals(emptyList(), problems)
    }

    @Test
    fun `the first line of Java for a statement says what it does`() {
        val translation = translationOf("pen down\n\nrepeat 4 times // sides\n  forward 20\nend\nbeep")
        val java = translation.java.lines()
        val loop = "for (int lap = 0; lap < 4; lap++) { // sides"
        val expected = mapOf(1 to "penDown();", 3 to loop, 4 to "forwardCentimetres(20);", 6 to "Sound.beep();")
        assertEquals(
            expected,
            expected.keys.associateWith {
                java[translation.lineMap.targetLinesOf(it).first() - 1].trim()
            },
        )
        assertEquals("}", java[translation.lineMap.targetLinesOf(5).single() - 1].trim())
    }

    @Test
    fun `a statement may have several lines of Java`() {
        val translation = translationOf("start forward")
        val java = translation.java.lines()
        assertEquals(
            listOf("Motor.A.forward();", "Motor.C.forward();"),
            translation.lineMap.targetLinesOf(1).map { java[it - 1].trim() },
        )
    }

    @Test
    fun `what no line of the program says has no line`() {
        val translation = translationOf("forward 20")
        val helper = translation.java.lines().indexOfFirst { "static void forwardCentimetres" in it } + 1
        assertTrue(helper > 0)
        assertNull(translation.lineMap.sourceLineOf(helper))
        assertNull(translation.lineMap.sourceLineOf(100_000))
        assertNull(translation.lineMap.sourceLineOf(0))
        assertEquals(emptyList(), translation.lineMap.targetLinesOf(7))
    }

    @Test
    fun `a light sensor in the header leads to the line that switches it on`() {
        val translation = translationOf("robot\n  light sensor on 3 facing down\nend\nshow light")
        val java = translation.java.lines()[translation.lineMap.targetLinesOf(2).single() - 1]
        assertContains(java, "Sensor.S3.activate();")
    }

    /** Whether [text] can be in the translation of any program. */
    private fun isCommon(text: String): Boolean =
        text.isEmpty() || text in COMMON || COMMON_BEGINNINGS.any { text.startsWith(it) }

    private companion object {
        val COMMON_BEGINNINGS =
            listOf(
                "import ",
                "public class ",
                "public static void main(",
                "/**",
                "static ",
                "// ",
                "Sensor.S",
                "Behavior[] ",
            )

        /** The fixed lines of behaviours, and the ends of blocks that only Java has. */
        val COMMON: Set<String> = listOf(
            "}",
            "mainThread = Thread.currentThread();",
            "new Reactions().start();",
            "private boolean isActive;",
            "public boolean takeControl() {",
            "public void action() {",
            "isActive = true;",
            "actionIsSuppressed = false;",
            "try {",
            "} catch (InterruptedException suppressed) {",
            "return false;",
            "isActive = false;",
            "giveWay();",
        ).toSet() + listOf("SUPPRESS", "MAIN_PROGRAM", "REACTIONS")
            .flatMap { name -> JavaTemplates.of(name, BrickKind.RCX, isReacting = true).lines().map { it.trim() } }
    }
}
