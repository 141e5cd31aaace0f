package robotran.blockediting

import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.offeredNames
import robotran.blockediting.palette.offeredValues
import robotran.blockediting.palette.textAt
import robotran.blockediting.shown.shownValue
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.Vocabulary
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What is offered at a touched value, and what it puts there. */
class OfferedValuesTest {
    private val touch = setOf(SensorKind.TOUCH)

    @Test
    fun `a condition is joined to another one, by and as by or`() {
        val offered = offeredFor("wait until left bumper\n", "left bumper")
        assertContains(offered, "left bumper and right bumper")
        assertContains(offered, "left bumper or right bumper")
        val other = offeredFor("wait until timer > 5\n", "timer > 5")
        assertContains(other, "(timer > 5) or left bumper")
        assertContains(offeredFor("wait until right bumper\n", "right bumper"), "right bumper or left bumper")
    }

    @Test
    fun `nothing is joined to itself`() {
        for (now in listOf("left bumper", "right bumper", "not left bumper")) {
            assertEquals(emptyList(), offeredFor("wait until $now\n", now).filter { "bumper and $now" in it }, now)
        }
    }

    @Test
    fun `in other words, too, a condition is joined to another one`() {
        val program = blocksOf(
            "warte bis linker fühler\n",
            messages = RobolangMessages.of(Language.ENGLISH),
            shown = Vocabulary.of(Language.GERMAN),
        )
        val part = program.partAt(program.span("linker fühler")) as PhrasePart.Value
        val offered = program.offeredValues(part, touch, BrickKind.RCX).map(program::shownValue)
        assertContains(offered, "linker fühler und rechter fühler")
        assertContains(offered, "linker fühler oder rechter fühler")
        val joined = Palette.blocks.first { it.id == "value-logic-or" }.textAt(part, program)
        assertEquals("linker fühler oder rechter fühler", program.shownValue(joined))
    }

    @Test
    fun `what is offered is what is put there, at values of every program`() {
        val random = Random(7)
        for ((name, text) in examplePrograms + tutorialPrograms) {
            val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
            val parts = program.outline.lines.flatMap { it.parts }.flatMap(::valuesIn)
            for (part in parts.shuffled(random).take(PARTS)) {
                val brick = BrickKind.entries.random(random)
                val offered = program.offeredNames(part) + program.offeredValues(part, touch, brick)
                for (choice in offered) {
                    val result = apply(program, BlockEdit.Replace(part.span, choice))
                    assertTrue(result is BlockEditResult.Success, "$name, ${part.span.textIn(text)}: $choice: $result")
                    val put = result.selection.textIn(result.program.text)
                    assertTrue(put == choice || put == "($choice)", "$name, ${part.span.textIn(text)}: $choice: $put")
                }
            }
        }
    }

    @Test
    fun `a word that is offered for another is the one that is put there`() {
        for ((name, text) in examplePrograms + tutorialPrograms) {
            val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
            val choices = program.outline.lines.flatMap { it.parts }.filterIsInstance<PhrasePart.Choice>()
            for (choice in choices.distinctBy { it.options to it.span.textIn(text) }) {
                for (word in choice.options) {
                    val result = program.done(BlockEdit.Replace(choice.span, word))
                    val span = SourceSpan(choice.span.start, choice.span.start + word.length)
                    assertEquals(word, span.textIn(result.program.text), name)
                }
            }
        }
    }

    private fun offeredFor(text: String, value: String): List<String> {
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
        val part = program.partAt(program.span(value)) as PhrasePart.Value
        return program.offeredValues(part, touch, BrickKind.RCX)
    }

    private fun valuesIn(part: PhrasePart): List<PhrasePart.Value> =
        if (part is PhrasePart.Value) listOf(part) + part.value.parts.flatMap(::valuesIn) else emptyList()

    private companion object {
        /** Values looked at in each program. */
        const val PARTS = 3
    }
}
