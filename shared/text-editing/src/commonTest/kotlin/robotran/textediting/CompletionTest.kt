package robotran.textediting

import robotran.brick.kind.BrickKind
import robotran.javacompiler.edit.BrickApi
import robotran.language.ProgramLanguage
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.CompletionList
import robotran.programs.support
import robotran.textediting.complete.completed
import robotran.textediting.complete.completionsAt
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class CompletionTest {
    private val help = CompletionHelp { word -> "About $word.".takeIf { word == "forward" } }

    private fun draft(marked: String) = TextDocument(marked.replace("|", ""), TextSelection(marked.indexOf('|')))

    private fun offered(
        marked: String,
        language: ProgramLanguage = ProgramLanguage.ROBOLANG,
        isExplicit: Boolean = false,
    ): CompletionList? = completionsAt(draft(marked), language.support.code, help, isExplicit, brick = BrickKind.RCX)

    private fun labels(
        marked: String,
        language: ProgramLanguage = ProgramLanguage.ROBOLANG,
        isExplicit: Boolean = false,
    ) = offered(marked, language, isExplicit)?.items?.map { it.label }.orEmpty()

    @Test
    fun `a line begins with a command, told in a line of help`() {
        val first = offered("fo|")?.items?.first()
        assertEquals("forward", first?.label)
        assertEquals("About forward.", first?.help)
    }

    @Test
    fun `NQC offers its functions, names of the program and what an argument is made for`() {
        val first = offered("task main()\n{\n    OnF|", ProgramLanguage.NQC)?.items?.first()
        assertEquals("OnFwd(outputs)", first?.label)
        assertEquals("OnFwd();", first?.inserted)
        assertTrue("OUT_A" in labels("task main()\n{\n    OnFwd(OU|", ProgramLanguage.NQC))
        assertTrue("speed" in labels("int speed;\ntask main()\n{\n    Wait(sp|", ProgramLanguage.NQC))
        assertNull(offered("// OnF|", ProgramLanguage.NQC))
        assertNull(offered("task main()\n{\n    |", ProgramLanguage.NQC))
    }

    @Test
    fun `a line of assembly text begins with a command`() {
        assertEquals(listOf("wait"), labels("\ttask 0\n\twa|", ProgramLanguage.LASM))
        assertEquals("task", labels("|", ProgramLanguage.LASM, isExplicit = true).first())
        assertNull(offered("\twait|", ProgramLanguage.LASM), "It is written.")
        assertNull(offered("\twait 2, s|", ProgramLanguage.LASM, isExplicit = true))
        assertNull(offered("; wa|", ProgramLanguage.LASM, isExplicit = true))
    }

    @Test
    fun `behind some words only a little makes sense`() {
        assertEquals(listOf("left", "right"), labels("turn |", isExplicit = true))
        assertEquals(listOf("down"), labels("pen d|"))
    }

    @Test
    fun `names of the program are offered, but not the one that is being written`() {
        assertTrue("side" in labels("const side = 20\nforward s|"))
        assertTrue("square()" in labels("procedure square(size)\nend\nsq|"))
        assertTrue("size" in labels("procedure square(size)\nforward s|\nend"))
        assertNull(offered("var zz|"))
    }

    @Test
    fun `what is offered depends on the brick`() {
        fun onNxt(marked: String) =
            completionsAt(draft(marked), ProgramLanguage.ROBOLANG.support.code, help, isExplicit = true, BrickKind.NXT)
                ?.items?.map { it.label }.orEmpty()
        assertEquals(emptyList(), labels("show dist|"))
        assertEquals(listOf("distance"), onNxt("show dist|"))
        assertEquals(listOf("distance"), labels("robot\n  brick nxt\nend\nshow dist|"))
        assertEquals(listOf("enter", "left", "right", "escape"), onNxt("wait until button |"))
        assertEquals(listOf("run", "view", "prgm"), labels("wait until button |", isExplicit = true))
        assertEquals(listOf("timer", "motor"), onNxt("reset |"))
    }

    @Test
    fun `in the header its lines are offered`() {
        assertEquals(listOf("light sensor on 2 facing down"), labels("robot\n  li|\nend"))
        assertEquals(listOf("sonar on 4", "sound sensor on 2"), labels("robot\n  brick nxt\n  so|\nend"))
        assertEquals(
            listOf("rcx", "nxt", "spike", "essential", "technic", "ev3", "microbit"),
            labels("robot\n  brick |\nend", isExplicit = true),
        )
    }

    @Test
    fun `nothing is offered in comments, numbers and texts, nor before anybody types`() {
        for (place in listOf("// fo|", "wait 2|", "show \"fo|\"", "|", "beep\n|")) assertNull(offered(place), place)
        assertNotNull(offered("|", isExplicit = true))
    }

    @Test
    fun `a whole block comes with its end, as far right as the line`() {
        val before = draft("if light < 3\n  repeat 4|\nend")
        val start = draft("if light < 3\n  rep|\nend")
        val list =
            assertNotNull(
                completionsAt(
                    start,
                    ProgramLanguage.ROBOLANG.support.code,
                    help,
                    isExplicit = false,
                    brick = BrickKind.RCX,
                ),
            )
        val block = list.items.first { it.label.startsWith("repeat 4") }
        val after = start.completed(list, block)
        assertEquals("if light < 3\n  repeat 4 times\n    \n  end\nend", after.text)
        assertEquals(2, after.lines.lineOf(after.selection.caret))
        assertNull(
            completionsAt(
                before,
                ProgramLanguage.ROBOLANG.support.code,
                help,
                isExplicit = false,
                brick = BrickKind.RCX,
            ),
        )
    }

    @Test
    fun `a function stands ready for its values`() {
        val before = draft("show ro|")
        val list =
            assertNotNull(
                completionsAt(
                    before,
                    ProgramLanguage.ROBOLANG.support.code,
                    help,
                    isExplicit = false,
                    brick = BrickKind.RCX,
                ),
            )
        val after = before.completed(list, list.items.first { it.label == "round()" })
        assertEquals("show round()", after.text)
        assertEquals(after.text.length - 1, after.selection.caret)
    }

    @Test
    fun `a word that needs a value comes with one to write over`() {
        assertEquals("forward <20>", chosen("fo|", "forward"))
        assertEquals("turn left <90>", chosen("turn le|", "left"))
        assertEquals("wait <1> second", chosen("wa|", "wait"))
        assertEquals("turn <>", chosen("tu|", "turn"))
        assertEquals("power left <5>", chosen("power l|", "left"))
        assertEquals("if left bumper<>", chosen("if l|", "left"))
        assertEquals("start forward<>", chosen("start f|", "forward"))
        assertEquals("start turning left<>", chosen("start turning l|", "left"))
        assertEquals("forward<> 30", chosen("fo| 30", "forward"), "there is one already")
        assertEquals("if (<>)", chosen("i|", "if", ProgramLanguage.JAVA))
        assertEquals("new <>", chosen("ne|", "new", ProgramLanguage.JAVA))
    }

    @Test
    fun `a word that is written out is not offered again, unless somebody asks`() {
        assertNull(offered("forward|"))
        assertNull(offered("while|", ProgramLanguage.JAVA))
        assertTrue("forward" in labels("forward|", isExplicit = true))
        assertEquals("forward <20>", chosen("forward|", "forward", isExplicit = true))
    }

    @Test
    fun `behind a word that one of a few has to follow those are offered`() {
        val turn = assertNotNull(offered("tu|")).items.first { it.label == "turn" }
        assertTrue(turn.offersNext)
        assertTrue(assertNotNull(offered("fo|")).items.none { it.offersNext })
    }

    /** The text after [label] was chosen, with the new selection between angle brackets. */
    private fun chosen(
        marked: String,
        label: String,
        language: ProgramLanguage = ProgramLanguage.ROBOLANG,
        isExplicit: Boolean = false,
    ): String {
        val list = assertNotNull(offered(marked, language, isExplicit), marked)
        val after = draft(marked).completed(list, list.items.first { it.label == label })
        return StringBuilder(after.text).insert(after.selection.end, '>').insert(after.selection.start, '<').toString()
    }

    @Test
    fun `a motor's methods are offered with what the library says about them`() {
        val items = offered("Motor.A.|", ProgramLanguage.JAVA)?.items.orEmpty()
        val forward = items.first { it.label == "forward()" }
        assertEquals("Turns the motor forward until it is told otherwise.", forward.help)
        assertTrue(items.any { it.label == "setPower(int power)" && it.caret == "setPower(".length })
        assertTrue(items.none { it.label == "A" || it.label.startsWith("run(") || it.label.startsWith("controlMotor") })
    }

    @Test
    fun `a class has its constants, a variable the methods of its class and those above`() {
        assertTrue("S1" in labels("Sensor.|", ProgramLanguage.JAVA))
        assertTrue("SENSOR_TYPE_LIGHT" in labels("SensorConstants.SENSOR_T|", ProgramLanguage.JAVA))
        assertTrue("readValue()" in labels("Sensor eye = Sensor.S2;\nint x = eye.r|", ProgramLanguage.JAVA))
        val ofThread = labels("Thread.sl|", ProgramLanguage.JAVA)
        assertTrue("sleep(long milliseconds)" in ofThread, "$ofThread")
        assertEquals(emptyList(), labels("nobody.|", ProgramLanguage.JAVA))
    }

    @Test
    fun `keywords, classes and names are offered in Java`() {
        assertTrue("while" in labels("whi|", ProgramLanguage.JAVA))
        assertTrue("Motor" in labels("Mot|", ProgramLanguage.JAVA))
        assertTrue("backAway()" in labels("void backAway() {}\nback|", ProgramLanguage.JAVA))
    }

    @Test
    fun `every class of the brick says something about itself and its members`() {
        for (name in listOf("Motor", "Sensor", "Button", "Sound", "LCD", "TextLCD", "Thread", "Math")) {
            val type = assertNotNull(BrickApi.of(BrickKind.RCX).classOf(name), name)
            assertTrue(type.help.isNotEmpty(), name)
            assertTrue(type.members.isNotEmpty(), name)
            assertEquals(emptyList(), type.members.filter { it.help.isEmpty() }, name)
        }
        val api = BrickApi.of(BrickKind.RCX)
        for (name in api.classNames) assertNotNull(api.classOf(name), name)
    }
}
