package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.language.source.SourceRange
import robotran.languagesupport.BrickMention
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class BrickOfProgramTest {
    private val javaFiles = ProgramLanguage.JAVA.support.files

    private fun brickOf(vararg texts: String) =
        javaFiles.brickOf(texts.mapIndexed { index, text -> SourceFile("Robot$index.java", text) })

    @Test
    fun `imports and qualified names tell the brick`() {
        assertEquals(BrickKind.NXT, brickOf("import lejos.nxt.*;\nclass Robot {}"))
        assertEquals(BrickKind.NXT, brickOf("class Robot { lejos.util.Delay d; }"))
        assertEquals(BrickKind.NXT, brickOf("import static lejos.nxt.LCD.drawInt;"))
        assertEquals(BrickKind.RCX, brickOf("import josx.platform.rcx.Motor;"))
        assertEquals(BrickKind.NXT, brickOf("class A {}", "import lejos.robotics.subsumption.Behavior;"))
    }

    @Test
    fun `a program that names no brick or both is for none`() {
        assertNull(brickOf("import java.util.*; class Robot {}"))
        assertNull(brickOf("import lejos.nxt.*; import josx.platform.rcx.*;"))
        assertNull(brickOf())
        assertNull(brickOf("class lejos { int josx; }"))
        assertNull(brickOf("import my.lejos.Robot; class A { int lejosx.y; }"))
    }

    private fun likely(text: String) = likelyBrickOf(Program("Robot.java", ProgramLanguage.JAVA, text))

    @Test
    fun `Java that an RCX cannot run is likely for an NXT`() {
        assertEquals(BrickKind.NXT, likely("class Robot { void say() { System.out.println(1); } }"))
        assertEquals(BrickKind.NXT, likely("import java.util.*; class Robot { List<String> names; }"))
        assertEquals(BrickKind.NXT, likely("class Robot { java.util.HashMap map; }"))
        assertEquals(BrickKind.RCX, likely("import josx.util.*; class Robot { String s = \"\" + System.out; }"))
        assertNull(likely("import java.util.*; class Robot { Vector v; Random r; String s = \"System.out\"; }"))
        assertNull(likely("class List { Map map; }"))
        assertNull(likely("import lejos.nxt.*; import josx.util.*; class Robot { void f() { System.out.println(); } }"))
        assertNull(likelyBrickOf(Program("x.robo", ProgramLanguage.ROBOLANG, "forward 3")))
    }

    @Test
    fun `comments and texts do not count`() {
        assertNull(brickOf("// import lejos.nxt.*;\nclass Robot { String s = \"lejos.nxt\"; /* josx.rcx */ }"))
        assertEquals(BrickKind.NXT, brickOf("String quote = \"\\\"\"; char c = '\\''; // it's\nlejos.nxt.Motor m;"))
        assertEquals(BrickKind.RCX, brickOf("/* open\n lejos.nxt */ import josx.util.*;"))
        assertNull(brickOf("String open = \"lejos.nxt.Motor"))
        assertNull(brickOf("/* lejos.nxt.Motor"))
        assertNull(brickOf("char wrong = '\\"))
    }

    @Test
    fun `a brick that is named a hundred thousand times is told`() {
        assertEquals(BrickKind.NXT, brickOf("import lejos.nxt.Motor;\n".repeat(100_000)))
    }

    @Test
    fun `the first mention has a place`() {
        val files = listOf(
            SourceFile("A.java", "class A {}"),
            SourceFile("B.java", "\n\nimport  lejos.nxt.Motor;\nimport lejos.util.*;"),
        )
        assertEquals(BrickMention(BrickKind.NXT, "B.java", SourceRange(3, 9, 24)), javaFiles.brickMentionIn(files))
    }

    @Test
    fun `class files tell the brick`() {
        fun classes(vararg constants: String) = brickOf(
            ProgramSource.CompiledClasses("x", mapOf("A" to constants.joinToString("\u0001").encodeToByteArray())),
        )
        assertEquals(BrickKind.NXT, classes("java/lang/Object", "lejos/nxt/Motor"))
        assertEquals(BrickKind.RCX, classes("Ljosx/platform/rcx/Motor;"))
        assertNull(classes("java/lang/Object"))
        assertNull(classes("lejos/nxt/Motor", "josx/util/Timer"))
    }
}
