package robotran.cli

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

/** Several programs on one brick. */
class SeveralProgramsTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    @Test
    fun `Prgm chooses among programs of either language in the order in which they were named`() {
        val java = javaProgram("Show", "LCD.showNumber(7);\nwhile (true) {}")
        val robolang = program("show 5\nrepeat forever\n  wait 1 second\nend\n")
        for ((first, second, shown) in listOf(Triple(robolang, java, "0007"), Triple(java, robolang, "5"))) {
            console.said.clear()
            val status =
                run(first, second, "--press", "prgm@1", "--press", "run@2", "--for", "4", "--brick-report", "-")
            assertEquals(0, status, console.complaints.joinToString())
            assertContains(console.said.single(), "\"program\": 1")
            assertContains(console.said.single(), "\"state\": \"running\"")
            assertContains(console.said.single(), "\"text\": \"$shown")
        }
    }

    @Test
    fun `without presses the first program runs`() {
        assertEquals(0, run(program("show 3\n"), javaProgram("Show", "LCD.showNumber(7);"), "--rom-log", "-"))
        assertContains(console.said.single(), "LCD number 3")
    }

    @Test
    fun `five programs are as many as a brick takes`() {
        val five = (1..5).map { program("show $it\n", "$it.robo") }.toTypedArray()
        assertEquals(0, run(*five))
        assertEquals(2, run(*five, javaProgram("Sixth", "")))
        assertEquals(listOf("A brick takes 5 programs at most, and these are 6."), console.complaints)
    }

    @Test
    fun `the mistakes of all programs are told`() {
        assertEquals(2, run(program("hop\n", "first.robo"), javaProgram("Second", "hop();")))
        assertEquals(
            listOf("$folder/first.robo:1:1", "$folder/Second.java:5:9"),
            console.complaints.map { it.substringBefore(": ") },
        )
    }

    @Test
    fun `a file that is named twice is one program`() {
        val file = javaProgram("Show", "LCD.showNumber(7);")
        assertEquals(0, run(file, file), console.complaints.joinToString())
    }
}
