package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.SourceFix

/** Explains constructors that a class does not have, or not for all. */
internal class ConstructorAdvisor(private val messages: JavaMessages) {
    fun advice(problem: EcjProblem, source: SourceText): ProblemExplanation? = when (problem.number) {
        ProblemId.UNDEFINED_CONSTRUCTOR -> undefined(problem, source)

        ProblemId.CONSTRUCTOR_NOT_VISIBLE -> {
            val name = shortened(problem.arguments[0])
            val constants = problem.members.take(MAX_NAMED).joinToString { "$name.$it" }
            ProblemExplanation(
                messages.madeAlready(name),
                if (constants.isEmpty()) messages.callOnClass(name) else messages.useOneOf(constants),
            )
        }

        else -> null
    }

    private fun undefined(problem: EcjProblem, source: SourceText): ProblemExplanation {
        val name = shortened(problem.arguments[0])
        val given = shortened(problem.arguments.getOrElse(1) { "" })
        val port = problem.members.firstNotNullOfOrNull(::portOf)
        val ways = problem.members.take(MAX_NAMED).joinToString { "new $name$it" }
        val hint = when {
            port != null -> messages.sayWherePluggedIn("new $name($port)")
            ways.isEmpty() -> null
            else -> messages.makeItLike(ways)
        }
        return ProblemExplanation(messages.wrongConstructor(name, given), hint, numberedPort(problem, source, port))
    }

    /** The first port for a constructor with these [parameters]. */
    private fun portOf(parameters: String): String? {
        val first = parameters.removePrefix("(").substringBefore(',').removeSuffix(")")
        return when {
            !first.endsWith("Port") -> null
            "Motor" in first -> "MotorPort.A"
            else -> "$SENSOR_PORT$FIRST_PORT"
        }
    }

    /** A sensor that is made of the number of its port. */
    private fun numberedPort(problem: EcjProblem, source: SourceText, port: String?): SourceFix? {
        val found = NUMBERED.find(source.words(problem.start, problem.end)) ?: return null
        if (port == null || !port.startsWith(SENSOR_PORT)) return null
        val number = found.groupValues[1]
        val start = problem.start + found.range.first + found.value.indexOf(number)
        return SourceFix(source.range(start, start + number.length), SENSOR_PORT + number)
    }

    private companion object {
        const val MAX_NAMED = 4
        const val SENSOR_PORT = "SensorPort.S"
        const val FIRST_PORT = 1
        val NUMBERED = Regex("""\(\s*([1-4])\s*\)$""")
    }
}
