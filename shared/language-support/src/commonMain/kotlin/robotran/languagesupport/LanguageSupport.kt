package robotran.languagesupport

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage

/** What Robotran asks of a programming language. The module of each language has one implementation. */
interface LanguageSupport {
    val language: ProgramLanguage

    /** What editors ask about its texts. */
    val code: CodeSyntax

    /** The files of its programs. */
    val files: ProgramFiles

    /** What grading asks about its programs. */
    val measure: ProgramMeasure

    /** The bricks that can run its programs. */
    val bricks: Set<BrickKind> get() = BrickKind.entries.toSet()

    /** Whether its programs run on LEGO's own firmware of the RCX. */
    val isForLegoFirmware: Boolean get() = false

    /** Whether its programs can be shown as blocks. */
    val hasBlocks: Boolean get() = false

    /** Whether it is only for those who ask for more than others: nobody is set tasks in it. */
    val isForExperts: Boolean get() = false

    /** Whether its compiler is fetched with the first program, and too slow to run on every keystroke. */
    val hasSlowCompiler: Boolean get() = false

    /** Whether lines of a compiled program name their file even if the program has only one. */
    val namesFileOfLines: Boolean get() = false

    /**
     * [program] in the words of [language], where programs can be written in those of several languages of people; laid
     * out as before. As it is if it cannot be.
     */
    fun inWords(program: String, language: Language): String = program

    /** The language of people whose words [program] has. */
    fun wordsOf(program: String): Language = Language.ENGLISH

    /** [piece], a few words of a program in the usual words, in those of [language]. */
    fun pieceInWords(piece: String, language: Language): String = piece

    /** [program] in the words in which help, hints and solutions are written. */
    fun inUsualWords(program: String): String = inWords(program, Language.ENGLISH)

    /** The [word] of [program] in those words. */
    fun usualWord(word: String, program: String): String = word

    /** The languages that its programs for a [brick] can be shown in, the usual one first. */
    fun translations(brick: BrickKind): List<ShownLanguage> = emptyList()
}
