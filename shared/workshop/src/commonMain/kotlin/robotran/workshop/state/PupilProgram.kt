package robotran.workshop.state

import robotran.language.ProgramLanguage
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.projects.ProjectLimits
import robotran.textediting.text.Draft

/**
 * A program as written by the pupil.
 *
 * @property files one or more if [ProgramLanguage.mayHaveFiles], otherwise one.
 */
data class PupilProgram(val files: List<ProgramFile>) {
    constructor(name: String, text: String) : this(listOf(ProgramFile(name, text)))

    /** The display name. */
    val name: String get() = files.first().name

    val language: ProgramLanguage get() = ProgramLanguage.ofFile(name) ?: ProgramLanguage.ROBOLANG

    /** Whether it is for LEGO's own firmware, not for leJOS. */
    val isForLegoFirmware: Boolean get() = source() is ProgramSource.ForLegoFirmware

    /** Whether there is no code. */
    val isBlank: Boolean get() = files.all { it.text.isBlank() }

    /** The total length of its files. */
    val characters: Int get() = files.sumOf { it.text.length }

    /** Whether the file with the index [index] may become [written]; an edit may always shorten it. */
    fun hasRoomFor(index: Int, written: Draft): Boolean {
        val now = files[index].text.length
        if (written.text.length <= now) return true
        val isShort = characters - now + written.text.length <= ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS
        return isShort && written.lines.count <= ProjectLimits.MAXIMUM_LINES
    }

    internal fun source(): ProgramSource = ProgramSource.of(language, name, files.map { SourceFile(it.name, it.text) })

    internal fun withText(file: Int, text: String): PupilProgram =
        copy(files = files.mapIndexed { index, old -> if (index == file) old.copy(text = text) else old })
}

fun PupilProgram.withPlainLineEnds(): PupilProgram = copy(
    files = files.map { it.copy(text = it.text.withPlainLineEnds()) },
)
