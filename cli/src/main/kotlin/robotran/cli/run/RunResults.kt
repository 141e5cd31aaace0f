package robotran.cli.run

import robotran.brick.log.CallLogFilter
import robotran.brick.log.toCsv
import robotran.brick.log.toLogText
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.cli.console.textOf
import robotran.cli.files.ON_CONSOLE
import robotran.cli.files.writeFile
import robotran.console.Console
import robotran.language.visibleText
import robotran.simulation.GoalReport
import robotran.simulation.RunReport
import robotran.simulation.RunStatus
import robotran.simulation.Session
import robotran.simulation.report
import kotlin.math.roundToInt

/**
 * Writes the results of a finished run.
 *
 * @param desktop renders the picture; null if none is requested.
 */
internal class RunResults(
    private val session: Session,
    private val console: Console,
    private val desktop: DesktopApp?,
) {
    private val messages = console.messages

    /** Writes all requested [outputs], prints a summary and returns errors for outputs that could not be written. */
    fun write(outputs: RunOutputs): List<String> {
        val report = session.report()
        val problems =
            listOfNotNull(
                outputs.picture?.let { writeFile(it, pictureFor(it), messages) },
                outputs.callLog?.let { writeOutput(it, romLogText(outputs)) },
                outputs.report?.let { writeOutput(it, report.toJson() + "\n") },
                outputs.brickReport?.let { writeOutput(it, brickReport(session) + "\n") },
                outputs.memory?.let { name -> session.memory()?.let { writeOutput(name, memoryListing(it)) } },
            )
        report.error?.let { console.complain(it) }
        session.warnings.forEach {
            console.complain(listOfNotNull(it.place(PlaceMessages.of(console.language)), it.message).joinToString(": "))
        }
        val forgotten = session.callLog.total - session.callLog.entries.size
        if (outputs.callLog != null && forgotten > 0) {
            console.complain(messages.romLogLacks(forgotten))
        }
        if (outputs.explains) explain()
        if (ON_CONSOLE !in
            listOf(outputs.callLog, outputs.report, outputs.brickReport, outputs.memory)
        ) {
            console.say(summary(report))
        }
        return problems
    }

    /** A picture in the format of the file extension of [name]. */
    private fun pictureFor(name: String): ByteArray {
        val pictures = checkNotNull(desktop) { "A picture needs the desktop app." }.pictures
        return if (name.endsWith(".svg", ignoreCase = true)) {
            pictures.svg(session.world, session.state).encodeToByteArray()
        } else {
            pictures.png(session.world, session.state)
        }
    }

    /** Prints for each robot why it deviated from its ideal path. */
    private fun explain() {
        val deviationCauses = session.explain()
        if (deviationCauses.isEmpty()) console.say(messages.nothingStrayed())
        val several = session.world.robots.size > 1
        for ((robot, described) in deviationCauses.groupBy { it.robot }) {
            if (several) console.say("$robot:")
            described.forEach { console.say(it.sentence) }
        }
    }

    private fun romLogText(outputs: RunOutputs): String {
        val filter = outputs.romLogGroups?.let { CallLogFilter(it) } ?: CallLogFilter()
        val entries = session.callLog.entries.filter(filter::accepts)
        return if (outputs.callLog.orEmpty().endsWith(
                ".csv",
                ignoreCase = true,
            )
        ) {
            entries.toCsv()
        } else {
            entries.toLogText()
        }
    }

    private fun writeOutput(name: String, text: String): String? = if (name == ON_CONSOLE) {
        console.say(text.trimEnd('\n'))
        null
    } else {
        writeFile(name, visibleText(text).encodeToByteArray(), messages)
    }

    /** A one-sentence summary of the run. */
    private fun summary(report: RunReport): String {
        val seconds = "${report.seconds}"
        val outcome =
            when (report.status) {
                RunStatus.ENDED -> messages.ended(seconds)
                RunStatus.RUNNING -> messages.timeUp(seconds)
                RunStatus.FAILED -> messages.failed(seconds)
            }
        val place = with(report.pose) { messages.robotIsAt("$x", "$y", "$heading", "${report.inkCentimetres}") }
        val explanation = session.state.brick.explanation.takeIf { report.status == RunStatus.ENDED }
        val sentences = listOfNotNull(outcome, place, explanation).joinToString(" ")
        return (listOf(sentences) + goalLines(report.goals, "")).joinToString("\n")
    }

    private fun goalLines(goals: List<GoalReport>, indentation: String): List<String> = goals.flatMap { goal ->
        val described = if (goal.met) {
            messages.goalMet(goal.goal)
        } else {
            messages.goalNotMet(
                goal.goal,
                (
                    goal.progress *
                        100
                ).roundToInt(),
            )
        }
        val missing = goal.shortfall?.takeIf { goal.parts.isEmpty() }?.let { "$indentation  ${messages.textOf(it)}" }
        listOfNotNull("$indentation$described", missing) + goalLines(goal.parts, "$indentation  ")
    }
}
