package robotran.blockediting

import robotran.blockediting.BlockDeed
import robotran.blockediting.messages.BlockMessages
import robotran.language.Language
import robotran.robolang.outline.ValueKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class MessagesTest {
    private val refusals = listOf(
        BlockRefusal.NotFound,
        BlockRefusal.IntoItself,
        BlockRefusal.OnlyOutermost,
        BlockRefusal.SettingOutsideRobot,
        BlockRefusal.OnlySettings,
        BlockRefusal.SecondRobot,
        BlockRefusal.TooDeep,
        BlockRefusal.TooLong,
        BlockRefusal.LooseEnd,
        BlockRefusal.NoSuchConstruct,
        BlockRefusal.ElseExists,
        BlockRefusal.NoValue("2,5 +", mistake = null),
        BlockRefusal.NumberNeeded,
        BlockRefusal.ConditionNeeded,
        BlockRefusal.ListNeeded,
        BlockRefusal.LastItem,
        BlockRefusal.NoSuchForm,
        BlockRefusal.NoChoice(listOf("left", "right")),
        BlockRefusal.NoName("2x"),
        BlockRefusal.NameTaken("side"),
        BlockRefusal.NoText,
        BlockRefusal.NoFix,
        BlockRefusal.NoNote,
        BlockRefusal.NothingToInsert,
        BlockRefusal.NoPlaceForValue,
        BlockRefusal.NothingToTry,
        BlockRefusal.ValueUnknown("side"),
        BlockRefusal.Mistaken(3, "X."),
    )

    private fun said(messages: BlockMessages): List<String> =
        refusals.map(messages::refusal) + BlockGroup.entries.map(messages::group) +
            ValueKind.entries.map(messages::kind) +
            (0..2).map(messages::inside) + (1..2).map(messages::blocks) +
            messages.position(1, 2) + BlockDeed.entries.map { messages.deed(it, "x") } +
            messages.note("x") + messages.emptyLine() + messages.mistake("x", "Y.")

    @Test
    fun `every sentence is another one in every language`() {
        val all = Language.entries.map { said(BlockMessages.of(it)) }
        for (index in all.first().indices) {
            val sentences = all.map { it[index] }
            assertTrue(sentences.toSet().size == Language.entries.size || sentences.first() == "Control", "$sentences")
        }
    }

    @Test
    fun `a refusal is one or two whole sentences that say what to do`() {
        for (language in Language.entries) {
            for (refusal in refusals) {
                val sentence = BlockMessages.of(language).refusal(refusal)
                assertTrue(sentence.endsWith('.') && sentence.first().let { it.isUpperCase() || it == '"' }, sentence)
                assertTrue(sentence.length <= 130 && '!' !in sentence, sentence)
            }
        }
    }

    @Test
    fun `what the parser knows about a value is said`() {
        val refusal = blocksOf("forward 20\n").let {
            it.refusal(BlockEdit.Replace(it.blocks.single().head.parts.last().span, "2,5"))
        }
        assertTrue(BlockMessages.of(Language.ENGLISH).refusal(refusal).startsWith("A number has a point"))
    }
}
