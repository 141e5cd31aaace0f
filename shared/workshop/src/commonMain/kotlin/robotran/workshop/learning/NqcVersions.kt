package robotran.workshop.learning

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.programs.SourceFile
import robotran.projects.PENBOT_TARGET
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.workshop.programs.asNqc
import robotran.workshop.state.PupilProgram

/** The programs that come with the tasks of worlds, in NQC. Programs in Robolang are translated. */
internal class NqcVersions {
    /** By name and text of the original; null for those that NQC cannot do. */
    private val translated = HashMap<SourceFile, PupilProgram?>()

    /** The program to begin with of [task] in NQC; null if NQC cannot do all of it. */
    fun start(task: Lesson): PupilProgram? = nqcOf(task, task.program, nqcName(task.program.name))

    /**
     * The solution of [task] in NQC, which a person or the translation has written; null as for [start], and where the
     * translation does not always reach the goals.
     */
    fun solution(task: Lesson): PupilProgram? =
        task.solutions.find { ProgramLanguage.ofFile(it.name) == ProgramLanguage.NQC }
            ?.let { PupilProgram(SOLUTION, it.text) }
            ?: if (task.name in TOO_SLOW) null else nqcOf(task, task.solution, SOLUTION)

    /** Whether [program] comes with a world. */
    fun has(program: PupilProgram): Boolean = program.language == ProgramLanguage.NQC &&
        WorldGallery.worlds.asSequence().flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }.any { task ->
            when (program.name) {
                SOLUTION -> solution(task) == program
                nqcName(task.program.name) -> start(task) == program
                else -> false
            }
        }

    private fun nqcOf(task: Lesson, file: SourceFile, name: String): PupilProgram? {
        if (file !in translated) translated[file] = translation(task, file, name)
        return translated[file]
    }

    private fun translation(task: Lesson, file: SourceFile, name: String): PupilProgram? {
        val isForRcx = task.brick.hasLegoFirmware && ProgramLanguage.ofFile(file.name) == ProgramLanguage.ROBOLANG
        val read = if (isForRcx) compileRobolang(file.name, file.text, PENBOT_TARGET) as? RobolangResult.Ready else null
        return read?.program?.asNqc(file.name, Language.ENGLISH)?.takeIf { it.remarks.isEmpty() }
            ?.let { PupilProgram(name, it.text) }
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
        fun nqcName(name: String): String = name.substringBeforeLast('.') + ProgramLanguage.NQC.extension
    }
}
