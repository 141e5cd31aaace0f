package robotran.blockediting

import robotran.blockediting.palette.MUSICAL_NOTES
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteHelp
import robotran.blockediting.palette.comparisonsFor
import robotran.blockediting.palette.introductions
import robotran.blockediting.palette.ownBlocks
import robotran.blockediting.palette.searchPalette
import robotran.blockediting.palette.textAt
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.sensors.SensorKind
import robotran.hub.model.HubModel
import robotran.language.Language
import robotran.microbit.buggy.Buggy
import robotran.microbit.model.MicrobitModel
import robotran.robolang.RobolangResult
import robotran.robolang.RobolangWords
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.robot.RobotTarget
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import kotlin.math.pow
import kotlin.math.roundToInt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

class PaletteTest {
    private val help = PaletteHelp { word, language -> sentences[word to language.tag] }

    private val all = BrickKind.entries.flatMap { Palette.blocksFor(it) }

    private fun found(query: String): List<String> = searchPalette(query, Palette.blocks, help).map { it.template }

    @Test
    fun `every word of the language has a block`() {
        val words = all.flatMap { it.words }.toSet()
        assertEquals(emptyList(), (RobolangWords.keywords + RobolangWords.functions.keys).filter { it !in words })
    }

    @Test
    fun `every block is a valid program of the blocks that it names`() = BrickKind.entries.forEach { brick ->
        val hub = HubModel.of(brick)
        val board = MicrobitModel.of(brick)
        val robot = when {
            hub != null -> RobotTarget.Hub(hub, 56.0, 112.0, MotorPort.A, MotorPort.B, pen = null)
            board != null -> RobotTarget.Microbit(board, Buggy.of(BuggyKind.CUTEBOT), 50.0, 5.0)
            brick == BrickKind.RCX -> RobotTarget.Rcx(50.0, 5.0)
            else -> RobotTarget.Nxt(5.6, 11.4)
        }
        for (block in Palette.blocksFor(brick)) {
            if (block.isValue) {
                val line = blocksOf(
                    "var v = ${block.template}",
                    messages = RobolangMessages.of(Language.ENGLISH),
                ).blocks.single()
                assertIs<Block.Command>(line, block.template)
                continue
            }
            val isSetting = LineForm.entries.any { it.isSetting && it.name.lowercase().replace('_', '-') == block.id }
            val inLoop = "repeat 2 times\n${block.template}\nend\n"
            val inFunction = "function f()\n${block.template}\nend\n"
            val source = when (block.id) {
                "break", "continue" -> inLoop
                "return-value" -> inFunction
                "return" -> inFunction.replace("function", "procedure")
                else -> if (isSetting) "robot\n${block.template}\nend\n" else block.template
            }
            val result = compileRobolang(block.id, source, robot, messages = RobolangMessages.of(Language.ENGLISH))
            assertIs<RobolangResult.Success>(result, "${block.template}: $result")
            val forms = blocksOf(source, messages = RobolangMessages.of(Language.ENGLISH)).all.mapNotNull {
                it.head.form
            }
            assertTrue(
                isSetting || forms.any {
                    it.name.lowercase().replace('_', '-') == block.id
                } || "else" in block.id,
                block.id,
            )
        }
        assertEquals(Palette.blocksFor(brick).size, Palette.blocksFor(brick).map { it.id }.toSet().size)
    }

    @Test
    fun `a value of one brick is a mistake on the other`() {
        val others = Palette.blocksFor(BrickKind.NXT).map { it.template } - Palette.blocks.map { it.template }.toSet()
        assertTrue("distance" in others && "motor A turn 90" in others && "button enter" in others, "$others")
        for (value in listOf("distance", "colour", "red", "loudness", "turned A", "button enter")) {
            assertIs<RobolangResult.Failure>(
                compileRobolang(
                    "a",
                    "var x = $value",
                    RobotTarget.Rcx(50.0, 5.0),
                    messages = RobolangMessages.of(Language.ENGLISH),
                ),
            )
        }
    }

    @Test
    fun `every form of a line has a block, or comes from the names of the program`() {
        val own = setOf(LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT, LineForm.CALL)
        val ids = all.map { it.id }
        val missing = LineForm.entries.filter { it.name.lowercase().replace('_', '-') !in ids }
        assertEquals(own + LineForm.END, missing.toSet())
        assertEquals(BlockGroup.entries.toSet(), Palette.blocks.map { it.group }.toSet())
    }

    @Test
    fun `a value fits where it is needed`() {
        for (block in all.filter { it.isValue }) {
            val program = blocksOf("var a = 1\n", messages = RobolangMessages.of(Language.ENGLISH))
            val value = checkNotNull(program.outline.lines.first().parts.last() as? PhrasePart.Value)
            assertIs<BlockEditResult.Success>(
                apply(program, BlockEdit.Replace(value.span, block.template)),
                block.template,
            )
        }
    }

    @Test
    fun `and has a block, and so has or, each introduced by the program that has it`() {
        assertEquals(
            listOf("left bumper and right bumper", "left bumper or right bumper"),
            Palette.blocks.filter { it.id.startsWith("value-logic") }.map { it.template },
        )
        assertEquals("left bumper or right bumper", found("or").first())
        val introduced = introductions(listOf(listOf("wait until light < 40 or right bumper")))
        assertTrue("value-logic-or" in introduced && "value-logic" !in introduced, "$introduced")
    }

    @Test
    fun `a value that is put where one of its own stands says just what its block says`() {
        for ((block, now, expected) in listOf(
            Triple("value-logic", "left bumper", "left bumper and right bumper"),
            Triple("value-logic-or", "left bumper", "left bumper or right bumper"),
            Triple("value-logic-or", "right bumper", "left bumper or right bumper"),
            Triple("value-logic-or", "light < 40", "(light < 40) or left bumper"),
            Triple("value-not", "light < 40", "not (light < 40)"),
        )) {
            val program = blocksOf("wait until $now\n", messages = RobolangMessages.of(Language.ENGLISH))
            val part = program.partAt(program.span(now)) as PhrasePart.Value
            assertEquals(expected, Palette.blocks.first { it.id == block }.textAt(part, program), "$block at $now")
        }
    }

    @Test
    fun `names that exist are not declared again`() {
        val program = blocksOf("var x = 1\nprocedure double()\nend\n", messages = RobolangMessages.of(Language.ENGLISH))

        fun text(id: String) = Palette.blocks.first { it.id == id }.textFor(program)
        assertEquals("var x2 = 5", text("declare-variable"))
        assertEquals("function double2(x2)\n  return 2 * x2\nend", text("function"))
        assertEquals("forward 20", text("move"))
    }

    @Test
    fun `the names of the program have blocks`() {
        val program =
            blocksOf(
                "var a = [1]\nvar n = 2\nprocedure go(x, y)\nend\nfunction f()\n  return 1\nend\nstop\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        assertEquals(
            listOf("a", "a[0]", "a[0] = 5", "n", "n = n + 1", "go(5, 5)", "f()"),
            ownBlocks(program, program.at("stop")).map { it.template },
        )
        assertEquals(listOf("go(5, 5)", "f()"), ownBlocks(program, program.at("var a")).map { it.template })
    }

    @Test
    fun `blocks are found in all languages, with and without accents`() {
        assertEquals("forward 20", found("forw").first())
        for (word in listOf(
            "vorwarts",
            "adelante",
            "avance",
            "ande",
        )) {
            assertEquals("forward 20", found(word).first(), word)
        }
        assertEquals("repeat 4 times\nend", found("boucle").first())
        assertEquals("wait 1 second", found("esperar").first())
        assertTrue("pen down" in found("lapiz") && "pen down" in found("Stift") && "pen down" in found("dibujar"))
        assertTrue("forward 20" in found("fahren"))
        assertTrue("max(5, 5)" in found("max"))
        assertEquals(emptyList(), found("qqqq"))
        assertEquals(Palette.blocks.size, found("").size)
    }

    @Test
    fun `the block that says just what is searched for comes first`() {
        fun lines(query: String) = found(query).map { it.removeSuffix("\nend").lines().last() }
        assertEquals(listOf("else", "else if right bumper"), lines("else").take(2))
        assertEquals("else if right bumper", lines("else if").first())
        assertEquals("if left bumper", lines("if").first())
        assertEquals("pen down", lines("pen").first())
        assertTrue(lines("bumper").indexOf("left bumper") < lines("bumper").indexOf("else"))
    }

    @Test
    fun `header lines and bumpers are explained by their own words`() {
        fun word(id: String) = all.first { it.id == id }.explained.first { help.sentence(it, Language.ENGLISH) != null }
        assertEquals(
            listOf("sonar", "sound", "on", "on", "brick", "robot", "bumper"),
            listOf(
                "sonar",
                "sound-sensor",
                "colour-sensor",
                "light-sensor",
                "brick",
                "robot",
                "value-bumper",
            ).map(::word),
        )
    }

    @Test
    fun `sensing begins with what reads sensors`() = BrickKind.entries.forEach { brick ->
        val ids = Palette.blocksOf(BlockGroup.SENSE, brick).map { it.id }
        assertEquals(listOf("value-bumper", "value-light"), ids.take(2))
        assertTrue(ids.indexOf("reset-timer") > ids.indexOf("value-battery"), "$ids")
        if (brick == BrickKind.NXT) assertEquals("value-distance", ids[2])
    }

    @Test
    fun `blocks are found by what pupils call them`() {
        fun ids(query: String) = searchPalette(query, Palette.blocksFor(BrickKind.NXT), help).map { it.id }
        for (word in listOf("Wand", "Abstand", "pared", "obstacle")) assertTrue("value-distance" in ids(word), word)
        assertEquals("wait-until", ids("bis").first())
        assertEquals("wait-until", ids("hasta").first())
    }

    @Test
    fun `comparisons are those of the robot's sensors`() {
        val sensors = setOf(SensorKind.TOUCH, SensorKind.ULTRASONIC, SensorKind.COLOUR, SensorKind.SOUND)
        val ofNxt = comparisonsFor(sensors, BrickKind.NXT)
        assertEquals(listOf("distance < 20", "colour == red", "loudness > 50"), ofNxt)
        assertEquals(listOf("light < 40"), comparisonsFor(setOf(SensorKind.LIGHT), BrickKind.RCX))
        assertEquals(listOf("timer > 5"), comparisonsFor(emptySet(), BrickKind.RCX))
        for (condition in ofNxt) {
            val program =
                compileRobolang(
                    "a",
                    "wait until $condition",
                    RobotTarget.Nxt(5.6, 11.4),
                    messages = RobolangMessages.of(Language.ENGLISH),
                )
            assertIs<RobolangResult.Success>(program, "$condition: $program")
        }
    }

    @Test
    fun `lessons say when a block is new`() {
        val lessons = tutorialPrograms.entries.groupBy({ it.key.substringBeforeLast('/') }, { it.value }).toList()
        val steps = listOf("drive/", "decide/").flatMap { strand ->
            lessons.filter { it.first.startsWith(strand) }.sortedBy { it.first }
        }
        val first = introductions(steps.map { it.second }).mapValues { steps[it.value].first }
        assertEquals("drive/01-first-drive", first["move"])
        assertEquals("drive/02-pen", first["pen"])
        assertEquals("drive/03-repeat", first["repeat"])
        assertEquals("drive/04-variables", first["declare-variable"])
        assertEquals("decide/02-bumpers", first["else"])
        assertEquals("drive/09-own-commands", first["procedure"])
        assertEquals("decide/04-whenever", first["whenever"])
        assertNull(first["motor"])
        assertTrue(
            first.keys.all { id ->
                id in OWN || Palette.blocks.any { it.id == id } || id == "end"
            },
            "${first.keys}",
        )
    }

    @Test
    fun `notes are those of equal temperament`() {
        val semitones = listOf(-9, -7, -5, -4, -2, 0, 2, 3, 5, 7, 8, 10, 12, 14, 15)
        assertEquals(semitones.map { (440 * 2.0.pow(it / 12.0)).roundToInt() }, MUSICAL_NOTES.map { it.frequency })
    }

    @Test
    fun `the word pages have sentences in every language`() {
        assertEquals(Language.entries.size, Language.entries.mapNotNull { help.sentence("forward", it) }.toSet().size)
    }

    private companion object {
        val SENTENCE = Regex("^- [a-z][a-z]: ")

        /** The sentences of the help by word and language. */
        val sentences: Map<Pair<String, String>, String> = buildMap {
            for (page in "\n${wordPages.values.single()}".split("\n# ").drop(1)) {
                val lines = page.lines()
                for (word in lines.first().split(", ")) {
                    for (line in lines.filter { SENTENCE.containsMatchIn(it) }) {
                        put(word to line.substring(2, 4), line.substringAfter(": "))
                    }
                }
            }
        }

        val OWN = setOf("assign", "assign-element", "call", "value-name", "value-element", "value-call")
    }
}
