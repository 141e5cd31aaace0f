package robotran.cli.packaging

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import robotran.assignments.course.OwnCourses
import robotran.assignments.course.courseFile
import robotran.assignments.course.pupilCopy
import robotran.cli.console.messages
import robotran.cli.files.writeFile
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking

/** `robotran course STRAND|worlds -o FILE`: writes a course that comes with Robotran. */
internal class CourseCommand(private val process: Console) : CoreCliktCommand("course") {
    private val course by argument("COURSE", help = OwnCourses.names.joinToString(", "))
    private val output by option("-o", "--output", metavar = "FILE", help = "the course file to write").required()
    private val isForPupils by option("--pupils", help = "without checks and solutions").flag()
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) =
        "Writes the lessons of a strand, or the worlds that have a task, as a course, to be read, changed and given to pupils."

    override fun run() {
        val own =
            OwnCourses.named(course, spoken.language, words = spoken.language)
                ?: refuse(console.messages.noSuchCourse(course, OwnCourses.names))
        val bytes =
            checkNotNull(courseFile(if (isForPupils) pupilCopy(own) else own)) { "Every course fits into a file." }
        writeFile(output, bytes, console.messages)?.let { refuse(it) }
    }

    private fun refuse(words: String): Nothing {
        console.complain(words)
        throw ProgramResult(ExitCode.BAD_INPUT.status)
    }
}
