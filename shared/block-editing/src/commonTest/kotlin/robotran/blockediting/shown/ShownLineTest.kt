package robotran.blockediting.shown

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockProgram
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.blockediting.describe.describe
import robotran.blockediting.messages.BlockMessages
import robotran.blockediting.palette.Palette
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.Vocabulary
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ShownLineTest {
    @Test
    fun `blocks speak each language in its order, whatever words the program has`() {
        val program = "turn left 90\nwait until right bumper\nrepeat forever\nend\nstart forward"
        assertEquals(
            "drehe nach links um 90|warte bis rechter fühler|wiederhole endlos|ende|starte vorwärts",
            shown(program, "de"),
        )
        assertEquals(
            "gira a la izquierda 90|espera hasta parachoques derecho|repite para siempre|fin|arranca hacia adelante",
            shown(program, "es"),
        )
        assertEquals(
            "tourne à gauche de 90|attends jusqu'à contact droit|répète sans fin|fin|démarre en avant",
            shown(program, "fr"),
        )
        assertEquals(
            "gire à esquerda 90|espere até contato direito|repita para sempre|fim|comece para frente",
            shown(program, "pt"),
        )
        assertEquals(program.replace("\n", "|"), shown(program, "en"))
    }

    @Test
    fun `a program in other words is shown in English, too`() {
        val program = "drehe rechts 90\nfür i von 1 bis 10\nende\nwenn licht < 40\nende"
        assertEquals("turn right 90|for i from 1 to 10|end|if light < 40|end", shown(program, "en"))
    }

    @Test
    fun `names, texts and calls stay as the pupil wrote them`() {
        val program = "var end1=5\nshow \"end\"\nprocedure jump(step2)\nend\njump( end1 )\nshow random(1,6)"
        assertEquals(
            "variable end1=5|zeige \"end\"|prozedur jump(step2)|ende|jump( end1 )|zeige random(1,6)",
            shown(program, "de"),
        )
    }

    @Test
    fun `a line or a value that a lesson quotes reads as its block, a single word as it is`() {
        fun german(code: String) = shownCode(code, Vocabulary.of(Language.GERMAN), Vocabulary.of(Language.GERMAN))

        fun spanish(code: String) = shownCode(code, Vocabulary.ENGLISH, Vocabulary.of(Language.SPANISH))
        assertEquals("drehe nach links um 90", german("drehe links 90"))
        assertEquals("vorwärts 20", german("vorwärts 20"))
        assertEquals("warte 0,5 sekunden", german("warte 0.5 sekunden"))
        assertEquals("wiederhole 4 mal", german("wiederhole 4 mal"))
        assertEquals("ende", german("ende"))
        assertEquals("gira a la izquierda 90", spanish("turn left 90"))
        assertEquals("parachoques izquierdo", spanish("left bumper"))
        assertEquals("repite para siempre", spanish("repeat forever"))
        assertEquals("luz < 40", spanish("light < 40"))
        assertEquals("potencia", spanish("power"))
        assertEquals("side", spanish("side"))
    }

    @Test
    fun `numbers have the decimal sign of the language, and the program keeps its point`() {
        assertEquals("warte 0,5 sekunden", shown("wait 0.5 seconds", "de"))
        assertEquals("wait 0.5 seconds", shown("warte 0.5 sekunden", "en"))
        val before = blocksIn("wait 0.5 seconds", "fr")
        val number = before.outline.lines.first().parts[1].span
        val after = assertIs<BlockEditResult.Success>(apply(before, BlockEdit.Replace(number, "2.5"))).program
        assertEquals("wait 2.5 seconds", after.text)
        assertEquals("attends 2,5 secondes", ShownLine(after, after.outline.lines.first()).sentence)
    }

    @Test
    fun `a screen reader hears the words on the block`() {
        val program = blocksIn("turn left 90", "de")
        assertEquals(
            "drehe nach links um 90 grad, Ebene 1",
            describe(program, program.blocks.first().id, BlockMessages.of(Language.GERMAN))?.sentence,
        )
        val side = program.outline.lines.first().parts[1] as PhrasePart.Choice
        assertEquals(
            "links, wähl links oder rechts",
            describe(program, side, BlockMessages.of(Language.GERMAN)).sentence,
        )
    }

    @Test
    fun `each phrase has every part that can be changed once`() {
        for (brick in BrickKind.entries) {
            for (block in Palette.blocksFor(brick)) {
                for (words in Vocabulary.all) {
                    val program =
                        blocksOf(
                            sourceOf(block.template, block.isValue, block.form?.isSetting == true),
                            ENGLISH,
                            shown = words,
                        )
                    for (line in program.outline.lines) {
                        val shown = ShownLine(program, line)
                        assertSameParts(line.parts, shown.pieces, "${block.id} $words")
                        line.parts.filterIsInstance<PhrasePart.Value>().forEach {
                            assertSameParts(it.value.parts, shown.piecesOf(it), "${block.id} $words")
                        }
                    }
                }
            }
        }
    }

    @Test
    fun `blocks of the palette are as they will stand in the program`() {
        val german = Vocabulary.of(Language.GERMAN)

        fun shown(id: String) = Palette.blocks.first { it.id == id }.shownIn(german)
        assertEquals(listOf("drehe nach links um 90"), shown("turn"))
        assertEquals(listOf("wiederhole 4 mal", "ende"), shown("repeat"))
        assertEquals(listOf("linker fühler"), shown("value-bumper"))
        assertEquals(listOf("lichtsensor an 2 schaut runter"), shown("light-sensor"))
        assertTrue(Palette.blocks.all { block -> block.shownIn(german).all { it.isNotBlank() } })
    }

    private fun assertSameParts(parts: List<PhrasePart>, pieces: List<ShownPiece>, clue: String) = assertEquals(
        parts.filter { it !is PhrasePart.Word }.toSet(),
        pieces.mapNotNull { (it as? ShownPiece.Part)?.part }.filter { it !is PhrasePart.Word }.toSet().also { shown ->
            assertEquals(shown.size, pieces.count { it is ShownPiece.Part && it.part !is PhrasePart.Word }, clue)
        },
        clue,
    )

    private fun sourceOf(template: String, isValue: Boolean, isSetting: Boolean) = when {
        isValue -> "show $template"
        isSetting -> "robot\n$template\nend"
        else -> template
    }

    private fun shown(text: String, tag: String): String {
        val program = blocksIn(text, tag)
        return program.outline.lines.joinToString("|") { ShownLine(program, it).sentence }
    }

    private fun blocksIn(text: String, tag: String): BlockProgram =
        blocksOf(text, ENGLISH, shown = Vocabulary.of(checkNotNull(Language.of(tag))))

    private companion object {
        val ENGLISH = RobolangMessages.of(Language.ENGLISH)
    }
}
