package robotran.legofirmware.support

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.ProgramMeasure
import robotran.languagesupport.SourceFile
import robotran.legofirmware.edit.LasmSyntax

/** The assembly text of LEGO's own firmware. */
object LasmSupport : LanguageSupport {
    override val language = ProgramLanguage.LASM
    override val code: CodeSyntax = LasmSyntax
    override val files: ProgramFiles = LasmFiles
    override val measure: ProgramMeasure = LasmMeasure
    override val bricks = setOf(BrickKind.ofLegoFirmware)
    override val isForLegoFirmware = true
    override val isForExperts = true
}

private object LasmFiles : ProgramFiles(ProgramLanguage.LASM) {
    override fun newProgram(name: String, brick: BrickKind): String = FIRST

    override fun brickOf(files: List<SourceFile>): BrickKind = BrickKind.ofLegoFirmware

    /** Drives for one second. */
    private val FIRST = listOf(
        "\ttask\t0",
        "\tdir\t2, 5 ",
        "\tout\t5, 2 ",
        "\twait\t2, 100 ",
        "\tout\t5, 1 ",
        "\tendt",
    ).joinToString("\n", postfix = "\n")
}

private object LasmMeasure : ProgramMeasure {
    override fun linesOfCode(text: String): Int = text.lineSequence().count { it.substringBefore(';').isNotBlank() }

    /** Labels are named after addresses, so a command's words are its mnemonic and numbers. */
    override fun normalTokens(text: String): Sequence<String> = text.lineSequence().flatMap { line ->
        WORD.findAll(line.substringBefore(';')).map { if (LABEL.matches(it.value)) ProgramMeasure.NAME else it.value }
    }

    private val WORD = Regex("[A-Za-z_]\\w*|-?\\d+")
    private val LABEL = Regex("[st]\\d{7}")
}
