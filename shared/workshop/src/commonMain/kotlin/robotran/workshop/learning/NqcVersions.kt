package robotran.workshop.learning

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.nqc.support.NqcSupport
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.support
import robotran.programs.translated
import robotran.projects.PENBOT_TARGET

/** The programs that come with the tasks of worlds, in NQC. Programs in Robolang are translated. */
internal class NqcVersions {
    private val language = NqcSupport.language

    private val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)

    /** By name and text of the original; null for those that NQC cannot do. */
    private val translated = HashMap<SourceFile, Program?>()

    /** The program to begin with of [task] in NQC; null if NQC cannot do all of it. */
    fun start(task: Lesson): Program? = nqcOf(task, task.program, nqcName(task.program.name))

    /**
     * The solution of [task] in NQC, which a person or the translation has written; null as for [start], and where the
     * translation does not always reach the goals.
     */
    fun solution(task: Lesson): Program? = task.solutions.find { ProgramLanguage.ofFile(it.name) == language }
        ?.let { Program.of(SOLUTION, it.text) }
        ?: if (task.name in TOO_SLOW) null else nqcOf(task, task.solution, SOLUTION)

    /** Whether [program] is one in NQC. */
    fun isIn(program: Program): Boolean = program.language == language

    /** Whether [program] comes with a world. */
    fun has(program: Program): Boolean = isIn(program) &&
        WorldGallery.worlds.asSequence().flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }.any { task ->
            when (program.name) {
                SOLUTION -> solution(task) == program
                nqcName(task.program.name) -> start(task) == program
                else -> false
            }
        }

    private fun nqcOf(task: Lesson, file: SourceFile, name: String): Program? {
        if (file !in translated) translated[file] = translation(task, file, name)
        return translated[file]
    }

    private fun translation(task: Lesson, file: SourceFile, name: String): Program? {
        val written = Program.of(file.name, file.text)
        val shown = written.language.support.translations(task.brick).find { it.programs == language } ?: return null
        val compiled = compiler.compileNow(written) as? ProgramResult.Success ?: return null
        return written.translated(compiled.program, shown, Language.ENGLISH)?.takeIf { it.notes.isEmpty() }
            ?.let { Program.of(name, it.text) }
    }

    companion object {
        private const val SOLUTION = "solution.nqc"

        /** Tasks whose solution in Robolang needs leJOS, which is faster than LEGO's firmware. */
        private val TOO_SLOW = listOf(
            "light-room/harder-1",
            "obstacle-course",
            "obstacle-course/harder-1",
            "sumo/harder-2",
        )
            .map { "world/$it" }

        /** The name of the version in NQC of the program [name]. */
        fun nqcName(name: String): String = name.substringBeforeLast('.') + NqcSupport.language.extension
    }
}
