package robotran.cli.grade

import com.github.ajalt.mordant.rendering.AnsiLevel
import com.github.ajalt.mordant.rendering.BorderType
import com.github.ajalt.mordant.rendering.OverflowWrap
import com.github.ajalt.mordant.rendering.TextAlign
import com.github.ajalt.mordant.rendering.Whitespace
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.table
import com.github.ajalt.mordant.terminal.Terminal
import robotran.cli.console.textOf
import robotran.cli.files.nameOf
import robotran.cli.messages.CommandMessages
import robotran.simulation.grade.Grade
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * The grades as text tables.
 *
 * @param commandFor returns the command that repeats the run of a program with a seed; null if there is none.
 */
internal class GradeTables(
    private val seeds: IntRange,
    private val messages: CommandMessages,
    private val commandFor: (program: String, seed: Int) -> String?,
) {
    /** The full result of one program: each goal, then the failed seeds. */
    fun ofProgram(program: ProgramGrades.Success): String {
        val rows = goalRows(program.grades.map { it.goals }, "")
        val table = render(listOf(messages.goalHeading(), messages.seedsMetHeading(), messages.worstHeading()), rows)
        val failed = program.grades.filterNot { it.passed }
        val described = failed.take(MAX_REPORTED).flatMap { failure(program.name, it) }
        return (listOf(table, sentence(program)) + described + rest(failed)).joinToString("\n")
    }

    /**
     * A table with one row per program, then the first failed seed of each failed program.
     *
     * @param areFiles whether programs are called by their files rather than by their pupils.
     */
    fun ofClass(programs: List<ProgramGrades>, areFiles: Boolean = true): String {
        val names = programs.map { if (areFiles) nameOf(it.shownName) else it.shownName }
        val areUnique = names.toSet().size == names.size
        val rows = programs.zip(names) { program, name ->
            listOf(if (areUnique) name else program.shownName) +
                classRow(program)
        }
        val headings =
            listOf(messages.programHeading(), messages.seedsPassedHeading(), messages.missedGoalHeading())
        val table = render(headings, rows)
        val failures = programs.filterIsInstance<ProgramGrades.Success>().mapNotNull { program ->
            val missed = program.grades.indexOfFirst { !it.passed }
            // The command line cannot run a variation of an assignment's world.
            missed.takeIf { it >= 0 && program.worlds[it].isEmpty() }
                ?.let { commandFor(program.name, program.grades[it].seed) }?.let { "${program.shownName}: $it" }
        }
        return (listOf(table) + failures).joinToString("\n")
    }

    private fun classRow(program: ProgramGrades): List<String> = when (program) {
        is ProgramGrades.Success -> {
            val missed = program.grades.firstNotNullOfOrNull { firstUnmet(it.goals) }
            listOf(messages.countOf(program.passed, program.grades.size), missed?.sentence.orEmpty())
        }

        is ProgramGrades.Failure -> {
            listOf("-", if (program.isReadable) messages.cannotRun() else messages.cannotBeUsed())
        }
    }

    /** @param runs the goals of each run; all runs have the same goals. */
    private fun goalRows(runs: List<List<GoalProgress>>, indentation: String): List<List<String>> =
        runs.first().indices.flatMap { number ->
            val goals = runs.map { it[number] }
            val min = goals.minBy { it.progress }
            val met = messages.countOf(goals.count { it.status == GoalStatus.MET }, goals.size)
            listOf(listOf(indentation + min.sentence, met, percent(min))) +
                goalRows(goals.map { it.parts }, "$indentation  ")
        }

    private fun sentence(program: ProgramGrades.Success): String = when (program.passed) {
        program.grades.size -> messages.meetsAll(program.shownName, inWords())
        else -> messages.meetsSome(program.shownName, program.passed, program.grades.size, inWords())
    }

    private fun failure(program: String, grade: Grade): List<String> {
        val goal = firstUnmet(grade.goals)
        val missed = messages.seedMissed(grade.seed, goal?.sentence, goal?.let(::percent).orEmpty())
        val described = grade.report.error?.let { messages.seedFailed(missed, it) } ?: missed
        val shortfall = firstShortfall(grade.report.goals)?.let { "  ${messages.textOf(it)}" }
        return listOfNotNull(described, shortfall, commandFor(program, grade.seed)?.let { "  $it" })
    }

    private fun inWords() = messages.seeds(seeds.first, seeds.last)

    private fun rest(failed: List<Grade>): List<String> {
        val others = failed.drop(MAX_REPORTED)
        return if (others.isEmpty()) {
            emptyList()
        } else {
            listOf(
                messages.moreSeeds(
                    others.size,
                    others.joinToString {
                        "${it.seed}"
                    },
                ),
            )
        }
    }

    private fun render(header: List<String>, rows: List<List<String>>): String {
        val widget = table {
            borderType = BorderType.ASCII
            whitespace = Whitespace.PRE_WRAP
            overflowWrap = OverflowWrap.BREAK_WORD
            header { rowFrom(header) }
            column(1) { align = TextAlign.RIGHT }
            tableBorders = Borders.ALL
            body {
                cellBorders = Borders.LEFT_RIGHT
                rows.forEach(::rowFrom)
            }
        }
        return terminal.render(widget).lines().joinToString("\n") { it.trimEnd() }.trimEnd()
    }

    private companion object {
        const val MAX_REPORTED = 10
        const val WIDTH = 110

        /** Only renders to strings; the console prints them. */
        val terminal =
            Terminal(ansiLevel = AnsiLevel.NONE, width = WIDTH, nonInteractiveWidth = WIDTH, interactive = false)
    }
}
