package robotran.robolang.translate

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse

class NamesTest {
    @Test
    fun `a name is the same in Java wherever it can be`() {
        val java = translationOf(
            "const Side = 20\nprocedure draw(length)\n  forward length\nend\ndraw(side)\nDRAW(SIDE)",
        ).java
        assertContains(java, "static final int Side = 20;")
        assertContains(java, "static void draw(int length)")
        assertEquals(2, java.split("draw(Side);").size - 1)
        assertFalse("in Robolang" in java)
    }

    @Test
    fun `words of Java get an underscore and a note`() {
        val java = translationOf("var class = 1\nvar double = 2.5\nshow class + double").java
        assertContains(java, "static int class_ = 1; // in Robolang: class")
        assertContains(java, "static float double_ = 2.5f; // in Robolang: double")
        assertContains(java, "show(class_ + double_);")
    }

    @Test
    fun `classes of leJOS keep their names`() {
        val java = translationOf("var Thread = 3\nfunction Math()\n  return 1\nend\nshow Thread + Math()").java
        assertContains(java, "show(Thread_ + Math_());")
    }

    @Test
    fun `a variable may be called like a method, and only then`() {
        val loop = "for round from 1 to 3\n  var main = round\n  show main\n  main()\nend"
        val java = translationOf("procedure main()\n  beep\nend\n$loop").java
        assertContains(java, "static void main_() { // in Robolang: main")
        assertContains(java, "for (int round = 1; round <= 3; round++) {")
        assertContains(java, "int main = round;")
        assertContains(java, "main_();")
    }

    @Test
    fun `names of the translation itself stay its own`() {
        val java = translationOf(
            "var arguments = 1\nvar timerStart = 2\nprocedure penDown()\n  pen down\nend\nreset " +
                "timer\npenDown()\nshow arguments + timerStart",
        ).java
        assertContains(java, "show(arguments_ + timerStart_);")
        assertContains(java, "static void penDown_()")
        assertContains(java, "penDown_();")
        assertContains(java, "static void penDown()")
    }

    @Test
    fun `names in blocks beside each other may be the same, inside each other they differ`() {
        val java = translationOf(
            "repeat 2 times\n  repeat 3 times\n    beep\n  end\nend\nrepeat 4 times\n  buzz\nend",
        ).java
        assertContains(java, "for (int lap = 0; lap < 2; lap++) {")
        assertContains(java, "for (int lap_ = 0; lap_ < 3; lap_++) {")
        assertContains(java, "for (int lap = 0; lap < 4; lap++) {")
    }

    @Test
    fun `letters beyond the alphabet stay if every Java knows them`() {
        val java = translationOf("var größe = 1\nshow größe").java
        assertContains(java, "static int größe = 1;")
        assertEquals("a_b", legal("a\u0375b"))
        assertEquals("_2nd", legal("2nd"))
    }

    @Test
    fun `a class is called like its file, in plain letters`() {
        val expected = mapOf(
            "square.robo" to "Square",
            "my square.robo" to "MySquare",
            "wall-bouncer.robo" to "WallBouncer",
            "C:\\school\\maze.robo" to "Maze",
            "home/maze.v2.robo" to "MazeV2",
            "2 robots!.robo" to "Program2Robots",
            "München.robo" to "Muenchen",
            "été.robo" to "Ete",
            "日本.robo" to "Program",
            "" to "Program",
            ".robo" to "Program",
            "___" to "Program",
            "motor.robo" to "ProgramMotor",
            "con.robo" to "ProgramCon",
            "reactions.robo" to "ProgramReactions",
            "whenever1.robo" to "ProgramWhenever1",
            "a\"; rm -rf *.robo" to "ARmRf",
        )
        assertEquals(expected, expected.keys.associateWith(::classNameOf))
    }
}
