package robotran.nqc.support

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.NewFile
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.SourceFile
import robotran.languagesupport.uniqueName

internal object NqcFiles : ProgramFiles(ProgramLanguage.NQC) {
    override val endings get() = super.endings + HEADER

    /** What a program includes may have another ending. */
    override fun endingOf(name: String): String =
        if ('.' in name) name.substring(name.lastIndexOf('.')) else super.endingOf(name)

    override fun newProgram(name: String, brick: BrickKind): String = FIRST

    /** What NQC does not include, it does not see. */
    override fun newFile(files: List<SourceFile>, brick: BrickKind): NewFile {
        val name = uniqueName("helper", HEADER, files.map { it.name })
        return NewFile(SourceFile(name, "void help()\n{\n\n}\n"), "#include \"$name\"")
    }

    override fun includes(text: String): List<String> = nqcIncludes(text)

    override fun programsOf(files: List<SourceFile>): List<List<SourceFile>> = nqcProgramsOf(files)

    override fun renamed(text: String, old: String, new: String): String =
        Regex("(?m)^([ \\t]*#[ \\t]*include[ \\t]+\")" + Regex.escape(old) + "\"")
            .replace(text) { "${it.groupValues[1]}$new\"" }

    override fun brickOf(files: List<SourceFile>): BrickKind = BrickKind.ofLegoFirmware

    private const val HEADER = ".nqh"

    /** Drives for one second: after two, the robot would be at the edge of the plain sheet. */
    private val FIRST = """
        task main()
        {
            OnFwd(OUT_A + OUT_C);
            Wait(100);
            Off(OUT_A + OUT_C);
        }
    """.trimIndent()
}
