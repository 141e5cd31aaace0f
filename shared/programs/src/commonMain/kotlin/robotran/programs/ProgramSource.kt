package robotran.programs

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile

/** A pupil's program: as written, or what another compiler has made of it. */
sealed interface ProgramSource {
    /** The program's name, usually the name of its first file. */
    val name: String

    /** The language of its [files]; null for what another compiler made. */
    val language: ProgramLanguage?

    /** Its texts, the first one first; empty for what another compiler made. */
    val files: List<SourceFile>

    /** Whether it is for LEGO's own firmware of the RCX. */
    val isForLegoFirmware: Boolean

    /**
     * A program in Java that was compiled elsewhere.
     *
     * @property classFiles the contents of its class files by file name.
     * @property mainClass the main class, with slashes; null for the first class with a main method.
     */
    class CompiledClasses(
        override val name: String,
        val classFiles: Map<String, ByteArray>,
        val mainClass: String? = null,
    ) : ProgramSource {
        override val language get() = null
        override val files get() = emptyList<SourceFile>()
        override val isForLegoFirmware get() = false
    }

    /**
     * A program for LEGO's own firmware that was compiled elsewhere.
     *
     * @property bytes of its `.rcx` file.
     */
    class FirmwareImage(override val name: String, val bytes: ByteArray) : ProgramSource {
        override val language get() = null
        override val files get() = emptyList<SourceFile>()
        override val isForLegoFirmware get() = true
    }
}

/**
 * A program as its author wrote it.
 *
 * @property files one or more if [ProgramLanguage.mayHaveFiles], otherwise one. In Java, the main class is the class of
 * the first file if it has a main method, or else the first class that has one. In NQC, the first file is the program,
 * the others are those that it includes, by the part of their names after the folders.
 */
data class Program(
    override val name: String,
    override val language: ProgramLanguage,
    override val files: List<SourceFile>,
) : ProgramSource {
    /** A program of one file. */
    constructor(name: String, language: ProgramLanguage, text: String) :
        this(name, language, listOf(SourceFile(name, text)))

    override val isForLegoFirmware: Boolean get() = language.support.isForLegoFirmware

    /** The first file's text. */
    val text: String get() = files.first().text

    /** Whether there is no code. */
    val isBlank: Boolean get() = files.all { it.text.isBlank() }

    /** The total length of its files. */
    val characters: Int get() = files.sumOf { it.text.length }

    /** The same program in the words of [language]; see [robotran.languagesupport.LanguageSupport.inWords]. */
    fun inWords(language: Language): Program =
        copy(files = files.map { it.copy(text = this.language.support.inWords(it.text, language)) })

    /** The same program in the words of those that come with the app, to be compared with them. */
    fun inUsualWords(): Program = inWords(Language.ENGLISH)

    /** The same program with [text] in the file with the index [index]. */
    fun withText(index: Int, text: String): Program =
        copy(files = files.mapIndexed { other, old -> if (other == index) old.copy(text = text) else old })

    /** The same program with other [files], named after the first one. */
    fun withFiles(files: List<SourceFile>): Program = Program(files.first().name, language, files)

    companion object {
        /** The program of [files], in the language that the name of the first one tells. */
        fun of(files: List<SourceFile>): Program =
            files.first().name.let { Program(it, ProgramLanguage.ofFileOrDefault(it), files) }

        /** The program of one file, in the language that its [name] tells. */
        fun of(name: String, text: String): Program = of(listOf(SourceFile(name, text)))
    }
}
