package robotran.languagesupport

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.language.source.SourceRange

/** The files of the programs in a [language]. */
open class ProgramFiles(private val language: ProgramLanguage) {
    /** The endings of the files that a program can have. */
    open val endings: List<String> get() = listOf(language.extension)

    /** Whether a file must have the name of what is in it, such as a class. */
    open val isNamedByContent: Boolean get() = false

    /** The same file with the name that [isNamedByContent] demands, and where its content tells none, with [stem]. */
    open fun namedByContent(file: SourceFile, stem: String): SourceFile = file

    /** Whether a program can start in the file [text]. */
    open fun canStart(text: String): Boolean = true

    /** The usual name of a file about [subject], a word in lower case. */
    open fun nameFor(subject: String): String = subject + language.extension

    /** The ending of the file [name] of a program. */
    open fun endingOf(name: String): String = language.extension

    /** Whether a file can be called [bare], a name without its ending, as far as the language cares. */
    open fun isValidName(bare: String): Boolean = true

    /** The text of a new program in the file [name] for a [brick]. */
    open fun newProgram(name: String, brick: BrickKind): String = ""

    /** Another file for the program of [files]; null if it can have only one. */
    open fun newFile(files: List<SourceFile>, brick: BrickKind): NewFile? = null

    /** The names of the files that the [text] of a file includes, each once, as the text writes them. */
    open fun includes(text: String): List<String> = emptyList()

    /** The programs that [files] make, each with its first file first. */
    open fun programsOf(files: List<SourceFile>): List<List<SourceFile>> = files.map { listOf(it) }

    /** The [text] of a file of a program in which the file [old] becomes [new]. */
    open fun renamed(text: String, old: String, new: String): String = text

    /** A program to try [example], some lines of help for a [brick], in the file [name]. */
    open fun wrapped(example: String, name: String, brick: BrickKind): String = example

    /** The kind of brick that the program of [files] is for; null if it does not tell. */
    open fun brickOf(files: List<SourceFile>): BrickKind? = null

    /** Whether a program that names the brick [named] runs on a robot with the brick [robot]. */
    open fun isFor(named: BrickKind, robot: BrickKind): Boolean = named == robot

    /** The kind of brick that the program of [files] is for or, if it does not tell, most likely is for. */
    open fun likelyBrickOf(files: List<SourceFile>): BrickKind? = brickOf(files)

    /** The first place in [files] that names the brick that they are for; null if there is no such place. */
    open fun brickMentionIn(files: List<SourceFile>): BrickMention? = null
}

/**
 * One file of a program.
 *
 * @property name its name, with or without folders, such as `Square.java`; it must match a public class in the file.
 * @property text its content, with any line breaks.
 */
data class SourceFile(val name: String, val text: String)

/**
 * Another file of a program.
 *
 * @property lineOfFirst what the program's first file must begin with to use it; null for nothing.
 */
class NewFile(val file: SourceFile, val lineOfFirst: String? = null)

/**
 * The first place where a program names something that only one kind of brick has.
 *
 * @property file the name of the file.
 * @property range the name, such as `lejos.nxt.Motor`, in an import or in code.
 */
data class BrickMention(val kind: BrickKind, val file: String, val range: SourceRange)

/** The file name [stem] with [ending], and a number between them if it is one of [taken]. */
fun uniqueName(stem: String, ending: String, taken: List<String>): String =
    generateSequence(1) { it + 1 }.map { if (it == 1) "$stem$ending" else "$stem$it$ending" }.first { it !in taken }

/** The name of a file without its folders. */
fun simpleName(path: String): String = path.substringAfterLast('/').substringAfterLast('\\')
