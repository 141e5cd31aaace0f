package robotran.programs

import robotran.brick.program.BrickProgram
import robotran.javacompiler.support.JavaSupport
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.SourceFile
import robotran.legofirmware.support.LasmSupport
import robotran.nqc.support.NqcSupport
import robotran.robolang.python.PythonSyntax
import robotran.robolang.robot.RobotTarget
import robotran.robolang.support.RobolangSupport

/** What Robotran knows of this programming language. */
val ProgramLanguage.support: LanguageSupport get() = LANGUAGES.getValue(this).support

/** What is asked of texts in this language. */
val ShownLanguage.code: CodeSyntax get() = programs?.support?.code ?: PythonSyntax

/** The language of the file [name], which may be a part of a program; null if its ending is none of a source. */
fun languageOfFile(name: String): ProgramLanguage? = ProgramLanguage.entries.find { language ->
    language.support.files.endings.any { name.endsWith(it, ignoreCase = true) }
}

/** The programs in [language] that [files] make. */
fun programsOf(files: List<SourceFile>, language: ProgramLanguage): List<Program> =
    language.support.files.programsOf(files).map { Program(it.first().name, language, it) }

/** The language whose programs can be shown as blocks. */
val blockLanguage: ProgramLanguage get() = LANGUAGES.values.single { it.support.hasBlocks }.support.language

/** The compiler of this programming language. */
internal fun ProgramLanguage.compiler(settings: CompilerSettings): LanguageCompiler =
    LANGUAGES.getValue(this).compiler(settings)

/**
 * What compilers are made for.
 *
 * @property language the language of messages.
 */
internal class CompilerSettings(
    val target: RobotTarget,
    val language: Language,
    val java: JavaToolchain,
    val firmware: FirmwareSettings,
)

/**
 * This program, which was compiled to [compiled], in the language [to], with notes in [language]. Null if programs in
 * its language are not translated.
 */
fun Program.translated(compiled: BrickProgram, to: ShownLanguage, language: Language): ProgramTranslation? =
    LANGUAGES.getValue(this.language).translator?.translate(this, compiled, to, language)

private class RegisteredLanguage(
    val support: LanguageSupport,
    val translator: ProgramTranslator? = null,
    val compiler: (CompilerSettings) -> LanguageCompiler,
)

/** All programming languages: a new one is one line here. */
private val LANGUAGES: Map<ProgramLanguage, RegisteredLanguage> = listOf(
    RegisteredLanguage(RobolangSupport, ROBOLANG_TRANSLATOR, ::RobolangProgramCompiler),
    RegisteredLanguage(JavaSupport) { it.java },
    RegisteredLanguage(NqcSupport, NQC_TRANSLATOR, ::NqcProgramCompiler),
    RegisteredLanguage(LasmSupport, compiler = ::LasmProgramCompiler),
).associateBy { it.support.language }
