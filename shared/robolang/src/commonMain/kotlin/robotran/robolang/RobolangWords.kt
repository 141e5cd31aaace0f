package robotran.robolang

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.words.Keyword
import robotran.robolang.words.OPENERS
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.lowercaseKeyword

/** The keywords and functions of Robolang, in lower case, for completion in an editor. */
object RobolangWords {
    /** The words that a line can begin with. */
    val commands: List<String> = Keyword.COMMANDS.filter { it != Keyword.LEFT && it != Keyword.RIGHT }.map { it.text }

    /** Those that begin a block. */
    internal val openers: Set<String> = OPENERS.mapTo(mutableSetOf()) { it.text }

    /** The operators that are words. */
    internal val operators: List<String> = BinaryOperator.entries.map { it.text }.filter { it.first().isLetter() }

    /** All words of the language, in English. */
    val keywords: List<String> = Keyword.entries.map { it.text }

    /** Whether [text] is a word in [vocabulary] that is a name instead in a program that declares it. */
    fun isNewerWord(text: String, vocabulary: Vocabulary = Vocabulary.ENGLISH): Boolean =
        vocabulary.keyword(text)?.yields == true

    /** The usual English spelling of a word in [vocabulary], such as `colour` for `Color`; null for any other [text]. */
    fun spellingOf(text: String, vocabulary: Vocabulary = Vocabulary.ENGLISH): String? =
        vocabulary.keyword(text)?.text ?: BuiltIn.of(lowercaseKeyword(text))?.text

    /** All words of the language that a program for [brick] can have. */
    internal fun keywordsOn(brick: BrickKind): List<String> = wordsOn(brick) { true }

    /** Those of them that begin a value, and the operators. */
    internal fun valueWordsOn(brick: BrickKind): List<String> =
        wordsOn(brick) { it.beginsValue || it.text in operators }

    private fun wordsOn(brick: BrickKind, isMeant: (Keyword) -> Boolean): List<String> =
        Keyword.entries.filter { it.isOn(brick) && isMeant(it) }.map { it.text }

    /** The built-in functions with their number of parameters. */
    val functions: Map<String, Int> = BuiltIn.entries.associate { it.text to it.parameters }
}
