package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.legofirmware.assembly.CommandHelp
import robotran.programs.support

/** The help on the words of one programming language. */
internal interface LanguageHelp {
    /** The words that have an entry, in the order of their file. */
    fun words(brick: BrickKind): List<String>

    /** The help in [language] on [word] for a [brick]; null if there is none. */
    fun on(word: String, language: Language, brick: BrickKind): WordHelp?

    /** The help on the word at [range] of the program [text]; null if there is none. */
    fun at(text: String, range: IntRange, language: Language, brick: BrickKind): WordHelp? =
        on(text.substring(range.first, range.last + 1), language, brick)
}

/** The help on this programming language; null if there is none. */
internal val ProgramLanguage.help: LanguageHelp? get() = HELP[this]

private val HELP: Map<ProgramLanguage, LanguageHelp> = mapOf(
    ProgramLanguage.ROBOLANG to RobolangHelp,
    ProgramLanguage.JAVA to JavaHelp,
    ProgramLanguage.NQC to NqcHelp,
    ProgramLanguage.LASM to LasmHelp,
)

private object RobolangHelp : LanguageHelp {
    override fun words(brick: BrickKind) = robolangWords.words

    override fun on(word: String, language: Language, brick: BrickKind) =
        robolangWords.help(lowercaseWord(word), language)

    override fun at(text: String, range: IntRange, language: Language, brick: BrickKind): WordHelp? {
        val word = text.substring(range.first, range.last + 1)
        return on(ProgramLanguage.ROBOLANG.support.usualWord(word, text), language, brick)
    }
}

private object JavaHelp : LanguageHelp {
    override fun words(brick: BrickKind) = javaWords(brick).words

    override fun on(word: String, language: Language, brick: BrickKind) = lejosHelp(word, language, brick)

    override fun at(text: String, range: IntRange, language: Language, brick: BrickKind) =
        helpInJava(language, text, range, brick)
}

private object NqcHelp : LanguageHelp {
    override fun words(brick: BrickKind) = nqcWords

    override fun on(word: String, language: Language, brick: BrickKind) = nqcHelp(word, language)
}

private object LasmHelp : LanguageHelp {
    override fun words(brick: BrickKind) = CommandHelp.mnemonics

    override fun on(word: String, language: Language, brick: BrickKind) = lasmHelp(word, language)
}

/** Lowercases only ASCII, which Robolang's words consist of: the platforms differ on some other letters. */
private fun lowercaseWord(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + ('a' - 'A') else it) } }
