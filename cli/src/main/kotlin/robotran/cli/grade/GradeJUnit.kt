package robotran.cli.grade

import robotran.cli.console.textOf
import robotran.cli.messages.CommandMessages
import robotran.language.visibleText
import robotran.simulation.GoalReport
import robotran.simulation.grade.Grade
import java.io.StringWriter
import javax.xml.stream.XMLOutputFactory
import javax.xml.stream.XMLStreamWriter

/**
 * All grades as JUnit XML: one test suite per program, one test case per world and seed. Times are virtual seconds.
 *
 * @param messages the words in it.
 */
internal fun gradeJUnit(worldTitle: String, programs: List<ProgramGrades>, messages: CommandMessages): String {
    val text = StringWriter()
    val xml = XMLOutputFactory.newInstance().createXMLStreamWriter(text)
    xml.writeStartDocument("UTF-8", "1.0")
    xml.element("testsuites") { programs.forEach { JUnitSuite(xml, worldTitle, messages).write(it) } }
    xml.writeEndDocument()
    xml.close()
    return text.toString()
}

private class JUnitSuite(
    private val xml: XMLStreamWriter,
    private val worldTitle: String,
    private val messages: CommandMessages,
) {
    fun write(program: ProgramGrades) {
        val grades = (program as? ProgramGrades.Success)?.grades.orEmpty()
        val parameters = listOf(
            "name" to program.shownName,
            "tests" to maxOf(1, grades.size),
            "failures" to grades.count { !it.passed },
            "errors" to if (program is ProgramGrades.Failure) 1 else 0,
            "skipped" to 0,
            "time" to grades.sumOf { it.seconds },
        )
        xml.element("testsuite", *parameters.toTypedArray()) {
            when (program) {
                is ProgramGrades.Failure -> case(program.shownName, 0.0) {
                    xml.element("error", "message" to program.reasons.first(), "type" to "mistakes") {
                        xml.characters(program.reasons)
                    }
                }

                is ProgramGrades.Success -> program.grades.zip(program.worlds, ::case)
            }
        }
    }

    private fun case(grade: Grade, world: String) {
        val name = listOf(world, messages.seeds(grade.seed, grade.seed)).filter { it.isNotEmpty() }.joinToString()
        case(name, grade.seconds) {
            if (!grade.passed) {
                val message = firstUnmet(grade.goals)?.sentence ?: messages.noGoal()
                xml.element("failure", "message" to message, "type" to "goals") {
                    val error = grade.report.error?.let(messages::programFailed)
                    xml.characters(unmetLines(grade.report.goals) + listOfNotNull(error))
                }
            }
        }
    }

    private fun case(name: String, seconds: Double, content: () -> Unit) =
        xml.element("testcase", "classname" to worldTitle, "name" to name, "time" to seconds, content = content)

    /** A line for each unmet goal, and one for what it lacked. */
    private fun unmetLines(goals: List<GoalReport>): List<String> = goals.filterNot { it.met }.flatMap { goal ->
        val shortfall = goal.shortfall?.takeIf { goal.parts.isEmpty() }?.let { "  ${messages.textOf(it)}" }
        listOfNotNull("${goal.goal} (${percent(goal.progress)})", shortfall) + unmetLines(goal.parts).map { "  $it" }
    }
}

private fun XMLStreamWriter.element(name: String, vararg attributes: Pair<String, Any>, content: () -> Unit) {
    writeCharacters("\n")
    writeStartElement(name)
    attributes.forEach { (key, value) -> writeAttribute(key, legal(value.toString())) }
    content()
    writeEndElement()
}

private fun XMLStreamWriter.characters(lines: List<String>) = writeCharacters(legal(lines.joinToString("\n")))

/** Characters that XML does not allow, such as a bell, are seen; two that are none are question marks. */
private fun legal(text: String): String = buildString {
    visibleText(text).codePoints().forEach { code ->
        val isLegal =
            code == 0x9 || code == 0xA || code == 0xD || code in 0x20..0xD7FF || code in 0xE000..0xFFFD ||
                code >= 0x10000
        appendCodePoint(if (isLegal) code else '?'.code)
    }
}
