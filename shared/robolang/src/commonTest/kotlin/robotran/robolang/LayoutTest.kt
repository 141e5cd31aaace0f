package robotran.robolang

import kotlin.test.Test
import kotlin.test.assertEquals

/** Layout does not affect a run. The programs in files all have the layout of `robotran format`. */
class LayoutTest {
    @Test
    fun `capital letters make no difference`() = assertRuns(
        "TURN Left 1 DEGREES // rom: 0x1a4e 0x2000 2 3 | 0x1a4e 0x2002 1 3 | 0x1a4e 0x2000 3 7 | 0x1a4e 0x2002 3 7\n" +
            "Repeat 2 Times\n  bEEp // rom 2 times: 0x299a 0x4004 0\nEND\n",
    )

    @Test
    fun `names may be written in small and capital letters`() =
        assertRuns("var Speed = 3\nspeed = SPEED + 1\nshow sPeEd // shows: 4\n")

    @Test
    fun `a name in other letters is no other name`() = assertRuns(
        "procedure p()\n  beep\nend\n" +
            "procedure P() // error 4:11 \"P\" is declared already, in line 1. Take another name.\n  buzz\nend\np()\n",
    )

    @Test
    fun `spaces and tabs make no difference`() = assertRuns(
        "   forward\t\t1   cm   // rom: 0x1a4e 0x2000 1 3 | 0x1a4e 0x2002 1 3 | 0x1a4e 0x2000 3 7 | 0x1a4e 0x2002 3 " +
            "7\n" +
            "\tbeep\t// rom: 0x299a 0x4004 0\n",
    )

    @Test
    fun `comments and blank lines make no difference`() = assertRuns(
        "// a comment alone\n\n   // an indented one\nbeep // rom: 0x299a 0x4004 0\n//\nbeep//rom: 0x299a 0x4004 0\n" +
            "// forward 20 is not a command in here\n",
    )

    @Test
    fun `only comments are a program that ends at once`() = assertRuns("// Nothing to do.\n\n// ends at 0\n")

    @Test
    fun `the last line needs no end`() = assertRuns("// ends at 50\nforward 1")

    private fun assertRuns(text: String) = assertEquals(emptyList(), differences(TestProgram("layout", text)))
}
