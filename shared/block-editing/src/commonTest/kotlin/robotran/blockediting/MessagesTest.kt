package robotran.blockediting

import robotran.blockediting.messages.BlockMessages
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.ValueKind
import kotlin.test.Test
import kotlin.test.assertTrue

class MessagesTest {
    private val errors = listOf(
        BlockEditError.NotFound,
        BlockEditError.IntoItself,
        BlockEditError.OnlyOutermost,
        BlockEditError.SettingOutsideRobot,
        BlockEditError.OnlySettings,
        BlockEditError.SecondRobot,
        BlockEditError.TooDeep,
        BlockEditError.TooLong,
        BlockEditError.LooseEnd,
        BlockEditError.NoSuchConstruct,
        BlockEditError.ElseExists,
        BlockEditError.NoValue("2,5 +", error = null),
        BlockEditError.NumberNeeded,
        BlockEditError.ConditionNeeded,
        BlockEditError.ListNeeded,
        BlockEditError.LastItem,
        BlockEditError.NoSuchForm,
        BlockEditError.NoChoice(listOf("left", "right")),
        BlockEditError.NoName("2x"),
        BlockEditError.NameTaken("side"),
        BlockEditError.NoText,
        BlockEditError.NoFix,
        BlockEditError.NoNote,
        BlockEditError.NothingToInsert,
        BlockEditError.NoPlaceForValue,
        BlockEditError.NothingToTry,
        BlockEditError.ValueUnknown("side"),
        BlockEditError.CompileError(3, "X."),
    )

    private fun said(messages: BlockMessages): List<String> =
        errors.map(messages::editError) + BlockGroup.entries.map(messages::group) +
            ValueKind.entries.map(messages::kind) +
            (0..2).map(messages::inside) + (1..2).map(messages::blocks) +
            messages.position(1, 2) + BlockDeed.entries.map { messages.deed(it, "x") } +
            messages.gone("x") + messages.undone(null) + messages.redone("X.") + messages.note("x") +
            messages.emptyLine() +
            messages.mistake("x", "Y.")

    @Test
    fun `no sentence is in English in another language`() {
        val english = said(BlockMessages.of(Language.ENGLISH))
        for (language in Language.entries - Language.ENGLISH) {
            for ((sentence, inEnglish) in said(BlockMessages.of(language)).zip(english)) {
                assertTrue(sentence != inEnglish || ' ' !in sentence, "$language: $sentence")
            }
        }
    }

    @Test
    fun `an error is one or two whole sentences that say what to do`() {
        for (language in Language.entries) {
            for (error in errors) {
                val sentence = BlockMessages.of(language).editError(error)
                assertTrue(sentence.endsWith('.') && sentence.first().let { it.isUpperCase() || it == '"' }, sentence)
                assertTrue(sentence.length <= 130 && '!' !in sentence, sentence)
            }
        }
    }

    @Test
    fun `what the parser knows about a value is said`() {
        val error = blocksOf("forward 20\n", messages = RobolangMessages.of(Language.ENGLISH)).let {
            it.editError(BlockEdit.Replace(it.blocks.single().head.parts.last().span, "2,5"))
        }
        assertTrue(BlockMessages.of(Language.ENGLISH).editError(error).startsWith("A number has a point"))
    }
}
